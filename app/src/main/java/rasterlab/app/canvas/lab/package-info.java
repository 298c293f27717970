/**
 * The layout that every lab has: hazards above the stage, the player below it, the inspector and
 * the actions at the right; what is said over the stage; and how an input is opened in another lab.
 * Start reading at {@link LabLayout}.
 */
package rasterlab.app.canvas.lab;
