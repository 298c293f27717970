/**
 * Stands for the sheet of an exercise that asks for steps in the window: the way to the lab where
 * it is answered, with the document itself folded away.
 *
 * <p>Start at {@link rasterlab.app.exercise.sheet.SheetFold}.
 */
package rasterlab.app.exercise.sheet;
