/*
 * A sandboxed frame may be forbidden to submit forms: then the browser does not even tell the page
 * that one was to be submitted. The page never lets a browser submit; it only wants to be told.
 */

/** Tells a form that it is submitted, if its boxes are valid. */
function submitted(form: HTMLFormElement): void {
  if (!form.reportValidity()) return;
  form.dispatchEvent(new SubmitEvent('submit', { bubbles: true, cancelable: true }));
}

/**
 * Lets forms be submitted by their buttons without the browser's leave. Enter in a box presses the
 * form's button.
 */
export function watchForms(root: Document): void {
  root.addEventListener('click', (event) => {
    const button = event.target instanceof Element ? event.target.closest('button') : null;
    if (button?.type !== 'submit' || !button.form || event.defaultPrevented) return;
    event.preventDefault();
    submitted(button.form);
  });
}
