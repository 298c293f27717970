// Lets the clock of an exam run by the seconds that the server says are left, and keeps what is typed: every few seconds
// where it has changed, and when time is over. What the server has not got yet is also kept in this window, for a reload
// while the network is away: under a name that is the student's own, since another may sign in here next.
"use strict";

const clock = document.querySelector("#clock");
const EVERY = 5000;

if (clock) {
  const shown = clock.querySelector(".left");
  const forms = [...document.querySelectorAll("form[data-draft]")];
  let end = performance.now() + 1000 * Number(clock.dataset.left);
  let over = false;

  // A form has one text, or the fields of a sheet of questions.
  const fieldsOf = (form) => [...form.elements].filter((field) => field.name && field.type !== "hidden");
  const read = (form) => JSON.stringify(fieldsOf(form).map((field) => [field.name, field.value]));
  const parsed = (typed) => {
    try {
      return JSON.parse(typed);
    } catch {
      return null;
    }
  };
  const isField = (one) => Array.isArray(one) && one.length === 2 && one.every((part) => typeof part === "string");
  // A window may still keep a text alone, not the fields of its form: that stands in the field for a source.
  const fieldsIn = (typed) => {
    const fields = parsed(typed);
    return Array.isArray(fields) && fields.every(isField) ? fields : [["source", typed]];
  };
  const write = (form, typed) => {
    for (const [name, text] of fieldsIn(typed)) {
      const field = form.elements.namedItem(name);
      if (field) field.value = text;
    }
  };

  const kept = new Map(forms.map((form) => [form, read(form)]));

  for (const form of forms) {
    const unsaved = sessionStorage.getItem(form.dataset.kept);
    if (unsaved !== null) write(form, unsaved);
    const note = () => sessionStorage.setItem(form.dataset.kept, read(form));
    form.addEventListener("input", note);
    form.addEventListener("change", note);
  }

  const keep = async (form) => {
    const text = read(form);
    if (text === kept.get(form)) return;
    const line = form.querySelector("[role=status]");
    const body = new FormData(form);
    body.set("quiet", "yes");
    try {
      const answer = await fetch(form.dataset.draft, { method: "POST", body, credentials: "same-origin" });
      if (!answer.ok) throw new Error(answer.statusText);
      kept.set(form, text);
      if (read(form) === text) sessionStorage.removeItem(form.dataset.kept);
      end = performance.now() + 1000 * Number(await answer.text());
      line.textContent = form.dataset.saved;
    } catch {
      line.textContent = form.dataset.failed;
    }
  };

  // Goes to what the server says of the end, which is not at the address of a form that was refused. While it cannot be reached, the page stays, and what is typed with it.
  const leave = async () => {
    try {
      await fetch(clock.dataset.exam, { method: "GET", credentials: "same-origin" });
      location.replace(clock.dataset.exam);
    } catch {
      setTimeout(leave, EVERY);
    }
  };

  const tick = () => {
    const left = Math.max(0, Math.ceil((end - performance.now()) / 1000));
    const two = (number) => String(number).padStart(2, "0");
    shown.textContent = `${Math.floor(left / 3600)}:${two(Math.floor(left / 60) % 60)}:${two(left % 60)}`;
    clock.classList.toggle("soon", left < 300);
    if (left > 0 || over) return;
    over = true;
    forms.forEach(keep);
    setTimeout(leave, 1000 * (Number(clock.dataset.grace) + 2));
  };

  tick();
  setInterval(tick, 1000);
  setInterval(() => forms.forEach(keep), EVERY);
}
