/**
 * The lab of OpenGL's stacks of matrices: a program of commands, what they leave on each stack, and
 * the cubes that it draws.
 *
 * <p>Matrices are shown in the textbook's layout, points as rows. Start with {@link
 * rasterlab.app.coordinates.stack.StackScene}; {@link
 * rasterlab.app.coordinates.stack.StackLabModel} knows no Swing.
 */
package rasterlab.app.coordinates.stack;
