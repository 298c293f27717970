/**
 * The labs' models, which outlive the panels that show them: made when first asked for, kept
 * between runs, and opened with an input of their topic. Start reading at {@link LabModels}.
 */
package rasterlab.app.shell.labs;
