package rasterlab.app.canvas.lab;

/**
 * A case of the user's own among the hazards of a topic.
 *
 * @param hazard shown like those of the topic
 * @param removal what the menu of its chip says
 * @param removing removes it for good
 */
public record OwnCase(HazardCase hazard, String removal, Runnable removing) {}
