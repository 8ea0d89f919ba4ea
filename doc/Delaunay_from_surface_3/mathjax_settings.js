MathJax.Hub.Config({
  showMathMenu: false, // it would need more of MathJax
  messageStyle: "none"
});
