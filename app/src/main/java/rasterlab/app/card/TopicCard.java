package rasterlab.app.card;

import rasterlab.app.canvas.TopicColours;

/**
 * All that the app has to know of a topic: which lab shows it, in which words and colours, and how
 * its inputs open there. What a topic computes is the engine's.
 *
 * @param topic its name as on the command line
 * @param lab whose tab shows it
 * @param texts where its methods and hazards are explained
 * @param labels where its hazards are called by their short names
 * @param colours of its methods in the lab and in every chart
 * @param way what shows its inputs
 * @param <M> the lab's model
 */
public record TopicCard<M>(
        String topic,
        LabRoom<M> lab,
        Place texts,
        Place labels,
        TopicColours colours,
        TopicWay<M> way) {
    /**
     * Texts of one topic among those of a package.
     *
     * @param feature the package below {@code rasterlab.app}, such as {@code line}
     * @param part what stands before names in the keys; "" where the texts of the package are those
     *     of one topic
     */
    public record Place(String feature, String part) {}

    /** A topic whose hazards are called and explained in one place. */
    public TopicCard(
            String topic, LabRoom<M> lab, Place texts, TopicColours colours, TopicWay<M> way) {
        this(topic, lab, texts, texts, colours, way);
    }
}
