// Gives each field that is marked `data-editor` an editor with line numbers and colours; without it the field works by itself.
// Keeps what is typed into a form that is marked `data-typed` in this browser, under a name that is the student's own, until it
// is handed in: then the page has more attempts (`data-attempts`) than when the form was sent.
"use strict";

const NARROW = "(max-width: 40rem)";

const editorFor = (field) => {
  const editor = CodeMirror.fromTextArea(field, {
    mode: field.dataset.editor,
    lineNumbers: true,
    lineWrapping: window.matchMedia(NARROW).matches,
    matchBrackets: true,
    indentUnit: 4,
    inputStyle: "contenteditable",
    viewportMargin: Infinity,
    screenReaderLabel: field.labels[0].textContent.trim(),
    // Whoever moves by Tab comes out of the editor; lines are indented by Ctrl+] and Ctrl+[, or Cmd.
    extraKeys: { Tab: false, "Shift-Tab": false },
  });
  const input = editor.getInputField();
  input.setAttribute("role", "textbox");
  input.setAttribute("aria-multiline", "true");
  editor.getWrapperElement().style.setProperty("--rows", field.rows);
  editor.on("change", () => {
    editor.save();
    field.dispatchEvent(new Event("input", { bubbles: true }));
  });
  return editor;
};

const draftOf = (name) => JSON.parse(localStorage.getItem(name) ?? "null");

const keepTyped = (form, editor) => {
  const { typed, attempts, back, drop } = form.dataset;
  const field = editor.getTextArea();
  const keep = (more) => localStorage.setItem(typed, JSON.stringify({ text: field.value, ...more }));
  const draft = draftOf(typed);
  const handedIn = draft && draft.attempts !== undefined && Number(attempts) > draft.attempts;
  if (handedIn) localStorage.removeItem(typed);
  else if (draft && draft.text !== "" && draft.text !== editor.getValue()) {
    if (editor.getValue() === "") {
      editor.setValue(draft.text);
      const line = document.createElement("p");
      line.className = "legend";
      line.setAttribute("role", "status");
      const button = document.createElement("button");
      button.type = "button";
      button.className = "plain";
      button.textContent = drop;
      button.addEventListener("click", () => {
        editor.setValue("");
        localStorage.removeItem(typed);
        line.remove();
        editor.focus();
      });
      line.append(`${back} `, button);
      form.prepend(line);
    }
  }
  field.addEventListener("input", () => keep({}));
  form.addEventListener("submit", () => keep({ attempts: Number(attempts) }));
};

for (const field of document.querySelectorAll("textarea[data-editor]")) {
  const editor = editorFor(field);
  if (field.form.dataset.typed) keepTyped(field.form, editor);
}
