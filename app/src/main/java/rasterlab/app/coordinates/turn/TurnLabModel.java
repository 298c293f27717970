package rasterlab.app.coordinates.turn;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.coordinates.figure.ChoiceModel;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.Turns;

/**
 * The lab of rotations without its window: which method, by which angle, how often.
 *
 * <p>Turning and judging run on a thread of the model's own, begun with the first look at {@link
 * #scene}; answers and commands all run on the thread of the executor it is given.
 */
public final class TurnLabModel extends ChoiceModel<TurnChoice> implements Steps, AutoCloseable {
    private final Topic<PlaneRotation, Turns, Images> topic;
    private final LatestOnly<TurnChoice, TurnScene> scenes;
    private TurnScene scene;
    private int step;
    private boolean stopped;

    /** A lab for a user without own programs. */
    public TurnLabModel(Executor events, Consumer<Throwable> onFailure) {
        this(new OwnMethods(), events, onFailure);
    }

    /**
     * @param own the programs of the user's
     * @param events runs what it is given on the one thread that uses this model, in order
     * @param onFailure told what turning threw, on any thread
     */
    public TurnLabModel(OwnMethods own, Executor events, Consumer<Throwable> onFailure) {
        super(TurnChoice.first());
        topic = own.in(new RotateTopic());
        scene = TurnScene.before(choice());
        scenes =
                new LatestOnly<>(
                        "rotation",
                        (choice, cancelled) -> TurnScene.of(topic, choice, cancelled),
                        (choice, answer) -> events.execute(() -> accept(answer)),
                        onFailure);
    }

    /** The newest finished scene, maybe of an earlier choice; empty before the first one. */
    TurnScene scene() {
        return scene;
    }

    /** Whether the newest choice's scene is on its way. */
    boolean busy() {
        return !stopped && !(scene.known() && scene.choice().equals(choice()));
    }

    /** Begins the work that the lab opens with, unless it has begun. */
    void begin() {
        if (!scene.known()) scenes.ask(choice());
    }

    /** Gives up the present work; what is shown stays. */
    void cancel() {
        scenes.cancel();
        stopped = true;
        tell();
    }

    /** The shell command that turns the same. */
    public String command() {
        return TurnCommand.of(choice());
    }

    List<Method<PlaneRotation>> methods() {
        return topic.methods();
    }

    Method<PlaneRotation> method() {
        return topic.method(choice().method());
    }

    List<Hazard<Turns>> hazards() {
        return topic.hazards();
    }

    /** Counted operations of one turn of one point; empty where the method refuses the point. */
    Map<String, Long> operations() {
        try {
            return topic.operations(method().implementation(), choice().turns(1));
        } catch (IllegalArgumentException refused) {
            return Map.of();
        }
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(choice().withMethod(topic.method(method).name()));
    }

    public void turnBy(double degrees) {
        change(choice().withDegrees(degrees));
    }

    /**
     * Turns so many times, from 1 to {@link PlaneRotation#MOST_TIMES}; a number outside goes to the
     * nearer end.
     */
    public void turnTimes(double times) {
        change(
                choice().withTimes(
                                (int)
                                        Math.max(
                                                1,
                                                Math.min(
                                                        PlaneRotation.MOST_TIMES,
                                                        Math.rint(times)))));
    }

    public void movePoint(double x, double y) {
        change(choice().withPoint(x, y));
    }

    public void show(Hazard<Turns> hazard) {
        show(hazard.input());
    }

    /** Turns the first of the points. */
    public void show(Turns turns) {
        rearrange(choice().with(turns));
    }

    @Override
    protected void chosen(TurnChoice next) {
        stopped = false;
        scenes.ask(next);
    }

    private void accept(TurnScene answer) {
        boolean ended = step == last();
        scene = answer;
        step = ended ? last() : Math.min(step, last());
        tell();
    }

    /** Waits until every choice so far is answered or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        scenes.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        scenes.close();
    }

    @Override
    public int last() {
        return scene.steps().size();
    }

    @Override
    public int step() {
        return step;
    }

    @Override
    public void goTo(int next) {
        int inside = Math.max(0, Math.min(last(), next));
        if (inside == step) return;
        step = inside;
        tell();
    }
}
