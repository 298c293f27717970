package rasterlab.app.exercise;

/**
 * A source that is lost when the window closes.
 *
 * @param exercise its id
 * @param problem why it is not on the disk
 */
public record UnsavedDraft(String exercise, String text, String problem) {}
