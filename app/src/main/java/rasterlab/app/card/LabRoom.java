package rasterlab.app.card;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;

/**
 * A lab of the window, as it stands behind its tab. Stateless: what the user does is in its model.
 *
 * @param <M> the model, which outlives the panels that show it
 */
public interface LabRoom<M> {
    /** Name of its tab. */
    String name();

    /** The package of its texts, below {@code rasterlab.app}. */
    default String texts() {
        return name();
    }

    /**
     * A new model; takes long.
     *
     * @param events runs what it is given on the one thread that uses the model, in order
     * @param onFailure told what background work threw, on any thread
     * @param own the user's programs, for a lab that has them among its methods
     */
    M model(Executor events, Consumer<Throwable> onFailure, OwnMethods own);

    /** Puts what is kept of the model between runs into a map, by the names it is kept under. */
    void keep(M model, Map<String, Kept<?>> kept);

    /** Ends the model's background work. */
    void close(M model);

    /** Does before what the first panel would take long for, on any thread; may be left undone. */
    default void prepare(M model) {}

    /** A new panel. On the event thread. */
    LabPanel panel(M model, Surroundings around);

    /**
     * Surrounds a panel.
     *
     * @param opening shows inputs in the tabs of their topics
     * @param onFailure told what the lab could not do, on any thread
     */
    record Surroundings(Language language, OpenInLab opening, Consumer<Throwable> onFailure) {}

    /** Whether it plays steps. */
    default boolean playsSteps() {
        return true;
    }

    /** A card for each topic that it shows; none for a lab that shows no topic's inputs. */
    default List<TopicCard<M>> cards() {
        return List.of();
    }

    /** Pictures of the lab that the tour shows. */
    List<LabShot<M>> shots();
}
