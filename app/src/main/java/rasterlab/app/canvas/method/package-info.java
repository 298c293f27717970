/**
 * The parts by which labs show a method: its colour, its name in a list, a teacher's words on it,
 * and the verdict on it beside a hazard. Start reading at {@link MethodColors}.
 */
package rasterlab.app.canvas.method;
