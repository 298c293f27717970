package rasterlab.app.card;

import rasterlab.app.canvas.method.TopicColors;

/**
 * All that the app has to know of a topic: which lab shows it, in which colours, and how its inputs
 * open there. What a topic computes is the engine's.
 *
 * @param topic its name as on the command line
 * @param lab whose tab shows it
 * @param colors of its methods in the lab and in every chart
 * @param way what shows its inputs
 * @param <M> the lab's model
 */
public record TopicCard<M>(String topic, LabRoom<M> lab, TopicColors colors, TopicBinding<M> way) {}
