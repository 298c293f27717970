package rasterlab.exercises.drawing;

import rasterlab.exercises.score.Message;

/**
 * One picture of a case.
 *
 * @param kind {@code expected}, {@code actual} or {@code difference}
 * @param png the picture's file
 * @param text what the picture shows, for people who do not see it
 */
public record DrawnPicture(String kind, byte[] png, Message text) {}
