package rasterlab.app.card;

import java.util.function.Consumer;

/**
 * A picture of a lab that the tour shows. What it is called is text {@code tour.NAME} of the lab's
 * package.
 *
 * @param name unlike every other picture's of the tour
 * @param prepare brings a lab as it opens to what is to be seen
 * @param <M> the lab's model
 */
public record LabShot<M>(String name, Consumer<M> prepare) {
    /** The lab as it opens. */
    public static <M> LabShot<M> first(String name) {
        return new LabShot<>(name, model -> {});
    }
}
