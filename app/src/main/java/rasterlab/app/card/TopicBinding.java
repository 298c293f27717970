package rasterlab.app.card;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.canvas.work.History;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.raster.Plotted;

/**
 * How a topic's inputs come into its lab.
 *
 * @param show shows a hazard
 * @param notes what is said of inputs that the lab cannot show as they are; empty for a lab that
 *     can
 * @param cases shows inputs together with what the user's program did; empty for a lab that cannot
 * @param anyInput whether the lab shows any input, not only hazards by their names
 * @param own shows the user's own program; empty for a lab that cannot run it
 * @param written tells the input that is shown; empty for a lab that cannot
 * @param <M> the lab's model
 */
public record TopicBinding<M>(
        Show<M> show,
        Optional<PictureNotes<M>> notes,
        Optional<Cases<M>> cases,
        boolean anyInput,
        Optional<ShowOwn<M>> own,
        Optional<InputWriter<M>> written) {
    /** Shows an input by a method of the topic, "" for the lab's own. */
    public interface Show<M> {
        void show(M lab, TopicInput input, String method);
    }

    /**
     * Words that are said beside a picture.
     *
     * @param differences in what the lab shows an input otherwise than it is; on any thread
     * @param drawsBy whether the picture shows what that method does
     * @param note says so beside the picture that is shown
     */
    public record PictureNotes<M>(
            InputComparison<M> differences,
            Predicate<String> drawsBy,
            BiConsumer<M, HazardNote> note) {}

    /** Finds in what a lab shows an input otherwise than it is. */
    public interface InputComparison<M> {
        List<ShownDifference> differences(M lab, TopicInput input, String method);
    }

    /**
     * Inputs of exercises.
     *
     * @param read makes an input from JSON; refuses with the place what cannot be read
     * @param show shows the input, by that method, beside what the user's program plotted
     */
    public record Cases<M>(Function<String, Object> read, ShowCase<M> show) {}

    /** Shows an input and what the user's program plotted for it. */
    public interface ShowCase<M> {
        void show(M lab, Object input, String method, Optional<Plotted> drawn);
    }

    /** Shows what the user's own program does beside a method of the topic. */
    public interface ShowOwn<M> {
        /**
         * @param input empty for the one that is shown
         */
        void show(M lab, Optional<TopicInput> input, String beside);
    }

    /** Tells the input that a lab shows. */
    public interface InputWriter<M> {
        /**
         * A JSON object, as {@code ./lab run} takes it; empty where the lab shows no such input.
         */
        Optional<String> input(M lab);
    }

    /** The way of a lab that shows every input of the topic as it is. */
    public static <M> TopicBinding<M> whole(Show<M> show) {
        return new TopicBinding<>(
                show, Optional.empty(), Optional.empty(), true, Optional.empty(), Optional.empty());
    }

    /** The way of a lab that says beside its picture in what that is unlike an input. */
    public static <M> TopicBinding<M> noted(Show<M> show, PictureNotes<M> notes) {
        return new TopicBinding<>(
                show,
                Optional.of(notes),
                Optional.empty(),
                true,
                Optional.empty(),
                Optional.empty());
    }

    /**
     * The way of a lab that is shown an input and then told a method, which are one change.
     *
     * @param history of what is shown
     */
    public static <M> TopicBinding<M> inTurn(
            Function<M, History<?>> history,
            BiConsumer<M, Object> show,
            BiConsumer<M, String> chooseMethod) {
        return whole(
                (lab, input, method) ->
                        history.apply(lab)
                                .asOne(
                                        () -> {
                                            show.accept(lab, input.input());
                                            if (!method.isEmpty()) chooseMethod.accept(lab, method);
                                        }));
    }

    /** This binding, which also shows cases of exercises. */
    public TopicBinding<M> reading(Cases<M> cases) {
        return new TopicBinding<>(show, notes, Optional.of(cases), anyInput, own, written);
    }

    /**
     * This binding in a lab whose command for the terminal begins with the input.
     *
     * @param command for what is shown; empty where no command does that
     */
    public TopicBinding<M> writing(String topic, Function<M, Optional<String>> command) {
        return writing(
                (InputWriter<M>)
                        lab -> command.apply(lab).flatMap(told -> CommandInput.in(topic, told)));
    }

    /** This binding in a lab that tells its input. */
    public TopicBinding<M> writing(InputWriter<M> input) {
        return new TopicBinding<>(show, notes, cases, anyInput, own, Optional.of(input));
    }

    /**
     * This binding in a lab that runs the user's own program as one of its methods, all in one
     * change.
     *
     * @param history of what is shown
     * @param enter shows the topic with its present input
     * @param compareWith shows a second method; does nothing where the lab shows one at a time
     */
    public TopicBinding<M> withOwn(
            Function<M, History<?>> history,
            Consumer<M> enter,
            BiConsumer<M, String> chooseMethod,
            BiConsumer<M, String> compareWith) {
        ShowOwn<M> showing =
                (lab, input, beside) ->
                        history.apply(lab)
                                .asOne(
                                        () -> {
                                            enter.accept(lab);
                                            input.ifPresent(one -> show.show(lab, one, beside));
                                            // The lab leaves the method and returns, since it may
                                            // be another program now.
                                            chooseMethod.accept(lab, beside);
                                            chooseMethod.accept(lab, OwnMethods.NAME);
                                            compareWith.accept(lab, beside);
                                        });
        return showingOwn(showing);
    }

    /** This binding in a lab that shows the user's own program in a way of its own. */
    public TopicBinding<M> showingOwn(ShowOwn<M> showing) {
        return new TopicBinding<>(show, notes, cases, anyInput, Optional.of(showing), written);
    }
}
