package rasterlab.app.row;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.coordinates.figure.ChoiceModel;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.depth.DepthBufferTopic;

/**
 * The lab of rows without its window: some topics, and whether their tab shows it.
 *
 * <p>Answers are found on a thread of the model's own; all else runs on the thread of the executor
 * it is given.
 */
public final class RowLabModel extends ChoiceModel<RowChoice> {
    private final List<RowKind<?, ?, ?>> kinds;

    private final LatestOnly<RowChoice, RowScene> answers;

    /** The choice, at its first pixel, whose scene was asked for last. */
    private Optional<RowChoice> asked = Optional.empty();

    /** Choices whose first wrong pixel is to be chosen once it is known; redo may bring them. */
    private final Set<RowChoice> sought = new HashSet<>();

    private Optional<Found> newest = Optional.empty();

    /** The tasks that wait for the scene of the present choice. */
    private final List<Runnable> waiting = new ArrayList<>();

    private boolean open;

    /** A scene and the choice, at its first pixel, that it is of. */
    private record Found(RowChoice choice, RowScene scene) {}

    RowLabModel(List<RowKind<?, ?, ?>> kinds, Executor events, Consumer<Throwable> onFailure) {
        super(first(kinds.get(0).topic()));
        this.kinds = kinds;
        answers =
                new LatestOnly<>(
                        "row",
                        (choice, cancelled) -> kind(choice).scene(choice),
                        (choice, scene) -> events.execute(() -> accept(choice, scene)),
                        onFailure);
    }

    /**
     * The model of the depths that buffers store, in rows and in triangles.
     *
     * @param own the programs of the user's
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what an answer threw, on any thread
     */
    public static RowLabModel ofDepths(
            OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        return new RowLabModel(depths(own), events, onFailure);
    }

    private static List<RowKind<?, ?, ?>> depths(OwnMethods own) {
        return List.of(new DepthKind(own.in(new DepthBufferTopic())), new DepthTriangleKind(own));
    }

    /** Names of the topics that {@link #ofDepths} has. */
    public static List<String> depthTopics() {
        return names(depths(new OwnMethods()));
    }

    /**
     * The model of textures: where they are looked up, and how they are filtered.
     *
     * @param own the programs of the user's
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what an answer threw, on any thread
     */
    public static RowLabModel ofTextures(
            OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        return new RowLabModel(textures(own), events, onFailure);
    }

    private static List<RowKind<?, ?, ?>> textures(OwnMethods own) {
        return List.of(new MappingKind(own), new FilterKind(own));
    }

    /** Names of the topics that {@link #ofTextures} has. */
    public static List<String> textureTopics() {
        return names(textures(new OwnMethods()));
    }

    private static List<String> names(List<RowKind<?, ?, ?>> kinds) {
        return kinds.stream().map(kind -> kind.topic().name()).toList();
    }

    private static RowChoice first(Topic<?, ?, ?> topic) {
        return new RowChoice(
                topic.name(), topic.hazards().get(1).name(), topic.methods().get(0).name(), 0);
    }

    /** Names of the topics whose rows can be shown. */
    public List<String> topics() {
        return names(kinds);
    }

    /** Whether there are questions on steps of the topic that is shown. */
    boolean asksSteps() {
        return kind(choice().topic()).asksSteps();
    }

    /** Whether the tab shows rows rather than its other lab. */
    public boolean open() {
        return open;
    }

    /** Shows the topic's rows, those of another topic from the first on. */
    public void open(String topic) {
        Topic<?, ?, ?> chosen = kind(topic).topic();
        if (!open) {
            open = true;
            tell();
        }
        if (!topic.equals(choice().topic())) rearrange(first(chosen));
    }

    /** Shows the tab's other lab. */
    public void close() {
        if (!open) return;
        open = false;
        tell();
    }

    /** Finds the right answers of all hazards; on any other thread. */
    void prepare() {
        hazards().forEach(each -> kind(each.topic()).prepare(each.hazard().name()));
    }

    /**
     * Shows a hazard from its first pixel that is wrong.
     *
     * @param method "" for the present one, or the first where the topic is another
     * @throws IllegalArgumentException naming what there is
     */
    public void show(String topic, String hazard, String method) {
        Topic<?, ?, ?> chosen = kind(topic).topic();
        boolean same = topic.equals(choice().topic());
        String kept = same ? choice().method() : chosen.methods().get(0).name();
        var next = new RowChoice(topic, hazard, method.isEmpty() ? kept : method, 0);
        kind(topic).require(next);
        open = true;
        if (isShown(next)) {
            rearrange(next.at(firstWrong(newest.orElseThrow().scene())));
        } else {
            sought.add(next);
            rearrange(next);
        }
        tell();
    }

    /**
     * Shows another input of the topic as it shows hazards.
     *
     * @param method "" for the present one, or the first where the topic is another
     * @throws IllegalArgumentException naming the methods there are
     */
    public void show(String topic, Object input, String method) {
        show(topic, kind(topic).given(input), method);
    }

    private static int firstWrong(RowScene scene) {
        for (int i = 0; i < scene.wrong().length; i++) if (scene.wrong()[i]) return i;
        return 0;
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(choice().withMethod(topic().method(method).name()));
    }

    /** Has the present choice answered again: the user's program may be another by now. */
    private void forget() {
        asked = Optional.empty();
        newest = Optional.empty();
    }

    /** Shows the topic's rows once more; those of another topic from the first on. */
    public void openAgain(String topic) {
        forget();
        open(topic);
        tell();
    }

    /** The present choice's scene; empty until it is found, which this asks for. */
    Optional<RowScene> shown() {
        RowChoice wanted = choice().at(0);
        if (asked.filter(wanted::equals).isEmpty()) {
            asked = Optional.of(wanted);
            answers.ask(wanted);
        }
        return isShown(wanted) ? newest.map(Found::scene) : Optional.empty();
    }

    private boolean isShown(RowChoice wanted) {
        return newest.filter(last -> last.choice().equals(wanted)).isPresent();
    }

    /** Runs it once the present choice's scene is there; not at all if another is chosen before. */
    void whenShown(Runnable then) {
        if (shown().isPresent()) then.run();
        else waiting.add(then);
    }

    private void accept(RowChoice answered, RowScene scene) {
        if (asked.filter(answered::equals).isEmpty()) return;
        if (!choice().at(0).equals(answered)) {
            asked = Optional.empty();
            return;
        }
        newest = Optional.of(new Found(answered, scene));
        if (sought.remove(answered)) choosePixel(firstWrong(scene));
        tell();
        var due = List.copyOf(waiting);
        waiting.clear();
        due.forEach(Runnable::run);
    }

    /** Waits until the scenes asked for so far are there. Any other thread. */
    public void settle() throws InterruptedException {
        answers.settle();
    }

    /** Ends the thread. */
    public void end() {
        answers.close();
    }

    Topic<?, ?, ?> topic() {
        return kind(choice()).topic();
    }

    /** The shell command that has the method answer to the row. */
    String command() {
        return "echo '%s' | ./lab run %s %s"
                .formatted(
                        kind(choice()).json(choice().hazard()),
                        choice().topic(),
                        OwnWords.known(choice().method(), "", choice().topic()));
    }

    /** The row's input in JSON; empty while rows of that topic are not shown. */
    public Optional<String> input(String topic) {
        return open && choice().topic().equals(topic)
                ? Optional.of(kind(topic).whole(choice().hazard()))
                : Optional.empty();
    }

    List<? extends Method<?>> methods(String topic) {
        return kind(topic).topic().methods();
    }

    /** The hazards of all its topics. */
    public Stream<TopicHazard> hazards() {
        return kinds.stream()
                .map(RowKind::topic)
                .flatMap(
                        topic ->
                                topic.hazards().stream()
                                        .map(each -> new TopicHazard(topic.name(), each)));
    }

    /** A hazard, and of which topic. */
    public record TopicHazard(String topic, Hazard<?> hazard) {}

    /** A pixel outside the row goes to the nearer end. */
    void choosePixel(int pixel) {
        pass(choice().at(Math.max(0, Math.min(pixels() - 1, pixel))));
    }

    int pixels() {
        return kind(choice()).pixels(choice().hazard());
    }

    /** The pixels as steps. */
    Steps steps() {
        return new Steps() {
            @Override
            public int last() {
                return pixels() - 1;
            }

            @Override
            public int step() {
                return choice().pixel();
            }

            @Override
            public void goTo(int step) {
                choosePixel(step);
            }
        };
    }

    private RowKind<?, ?, ?> kind(RowChoice choice) {
        return kind(choice.topic());
    }

    private RowKind<?, ?, ?> kind(String topic) {
        return Named.find("topic", topic, kinds, kind -> kind.topic().name());
    }

    @Override
    protected void chosen(RowChoice next) {
        kind(next).require(next);
        if (next.pixel() != 0) sought.remove(next.at(0));
        if (asked.filter(next.at(0)::equals).isEmpty()) waiting.clear();
    }

    /** Whether the lab was open, as it is kept between runs, beside the choice. */
    public Kept<Boolean> keptOpen() {
        return new Kept<>() {
            @Override
            public Class<Boolean> keptType() {
                return Boolean.class;
            }

            @Override
            public Boolean kept() {
                return open;
            }

            @Override
            public void restore(Boolean choice) {
                open = choice;
                tell();
            }
        };
    }
}
