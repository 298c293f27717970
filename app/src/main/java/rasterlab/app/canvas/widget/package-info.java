/**
 * Controls that every lab uses: numbers that are typed or dragged, lists of names, rows and
 * sentences that wrap, formulas with live numbers. Start reading at {@link NumberField}.
 */
package rasterlab.app.canvas.widget;
