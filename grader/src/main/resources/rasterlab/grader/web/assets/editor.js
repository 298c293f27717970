// Gives each field that is marked `data-editor` an editor with line numbers and colors; without it the field works by itself.
// Keeps what is typed into a form that is marked `data-typed` in this browser, under a name that is the student's own, until it
// is handed in: then the page has more attempts (`data-attempts`) than when the form was sent. follow.js forgets it on signing out.
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

// A browser may refuse to keep anything; then typing goes on without it.
const kept = {
  read(name) {
    try {
      return JSON.parse(localStorage.getItem(name));
    } catch (unreadable) {
      console.warn("a draft cannot be read", unreadable);
      return null;
    }
  },
  write(name, draft) {
    try {
      localStorage.setItem(name, JSON.stringify(draft));
    } catch (refused) {
      console.warn("a draft cannot be kept", refused);
    }
  },
};

const isWanted = (draft, attempts) =>
  draft && typeof draft.text === "string" && draft.text !== "" && !(draft.attempts < attempts);

const tellBack = (form, editor) => {
  const line = document.createElement("p");
  line.className = "legend";
  line.setAttribute("role", "status");
  const button = document.createElement("button");
  button.type = "button";
  button.className = "plain";
  button.textContent = form.dataset.drop;
  button.addEventListener("click", () => {
    editor.setValue("");
    line.remove();
    editor.focus();
  });
  line.append(`${form.dataset.back} `, button);
  form.prepend(line);
};

const keepTyped = (form, editor) => {
  const name = form.dataset.typed;
  const attempts = Number(form.dataset.attempts);
  const draft = kept.read(name);
  if (editor.getValue() === "" && isWanted(draft, attempts)) {
    editor.setValue(draft.text);
    tellBack(form, editor);
  }
  editor.on("change", () => kept.write(name, { text: editor.getValue() }));
  form.addEventListener("submit", () => kept.write(name, { text: editor.getValue(), attempts }));
};

for (const field of document.querySelectorAll("textarea[data-editor]")) {
  const editor = editorFor(field);
  if (field.form.dataset.typed) keepTyped(field.form, editor);
}
