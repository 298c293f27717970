package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/**
 * How a topic's inputs and outputs look as points of space.
 *
 * @param <C> contract of the topic's methods
 * @param <I> its input
 * @param <O> its output
 */
abstract class TrialKind<C, I, O> {
    private final Topic<C, I, O> topic;

    TrialKind(Topic<C, I, O> topic) {
        this.topic = topic;
    }

    final Topic<C, I, O> topic() {
        return topic;
    }

    /** The points, and matrices that do what the topic's methods should. */
    abstract PointList list(I input);

    abstract Images images(O output);

    /** H of each point; empty for a topic that divides by none. */
    abstract Optional<double[]> h(O output);

    /** The input with that point alone. */
    abstract I only(I input, int point);

    /** The output for that point alone. */
    abstract O outputOf(O output, int point);

    static double[] xyz(double[] all, int point) {
        return Arrays.copyOfRange(all, 3 * point, 3 * point + 3);
    }

    /**
     * @throws IllegalArgumentException naming the hazards there are
     */
    final Hazard<I> hazard(String name) {
        return GivenInput.hazard(topic, name);
    }

    /** The name of an input in the place of a hazard's. */
    @SuppressWarnings("unchecked") // of this topic
    final String given(Object input) {
        return GivenInput.name(topic, (I) input);
    }

    final PointList list(String hazard) {
        return list(hazard(hazard).input());
    }

    /**
     * The list as an input of the topic; empty where it is none.
     *
     * @param scene of a list that is no hazard of the topic
     */
    abstract Optional<I> listed(ListScene scene);

    /** Writes what is shown as an input of the topic, in JSON: the hazard itself, or the list. */
    final Optional<String> input(ListScene scene) {
        return scene.choice()
                .trial()
                .filter(shown -> shown.topic().equals(topic.name()))
                .map(shown -> hazard(shown.hazard()).input())
                .or(() -> listed(scene))
                .map(input -> GivenInput.name(topic, input));
    }

    /** The hazard as {@code ./lab run} reads it. */
    final String json(String hazard) {
        return CommandInput.of(topic.format(), hazard(hazard).input());
    }

    /** Tries the method; takes as long as the method does. */
    final TrialScene scene(Trial trial) {
        I input = hazard(trial.hazard()).input();
        var tried =
                HazardTrial.tried(
                        topic, topic.method(trial.method()), input, HazardTrial.WALL_LIMIT);
        O exact = tried.exact();
        int points = images(exact).size();
        Optional<O> made = tried.made().filter(output -> images(output).size() == points);
        return new TrialScene(
                trial,
                list(input).points().stream().mapToDouble(Double::doubleValue).toArray(),
                placed(exact),
                made.map(this::placed),
                made.map(output -> fates(input, exact, output)).orElse(List.of()),
                tried.verdict());
    }

    private TrialScene.TrialPoints placed(O output) {
        return new TrialScene.TrialPoints(images(output).coordinates(), h(output));
    }

    private List<TrialScene.Fate> fates(I input, O exact, O made) {
        var fates = new ArrayList<TrialScene.Fate>();
        for (int i = 0; i < images(exact).size(); i++)
            fates.add(
                    TrialScene.Fate.of(
                            images(exact).has(i),
                            images(made).has(i),
                            topic.correct(
                                    topic.compare(
                                            only(input, i),
                                            outputOf(exact, i),
                                            outputOf(made, i)))));
        return fates;
    }
}
