package rasterlab.app.coordinates.view;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.coordinates.figure.ChoiceModel;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.chain.TransformTopic;

/**
 * The lab of views without its window: which view, with which numbers, and which stage is shown.
 * The steps are the stages.
 */
public final class ViewLabModel extends ChoiceModel<ViewChoice> implements Steps {
    /** Degrees that a drag across the whole house turns. */
    private static final double TURN = 180;

    private final TransformTopic topic = new TransformTopic();
    private ViewScene scene;
    private int stage = ViewStage.CoordinateSpace.PICTURE.ordinal();

    public ViewLabModel() {
        super(ViewChoice.first());
        scene = ViewScene.of(topic, choice());
    }

    ViewScene scene() {
        return scene;
    }

    /** The stage that is shown. */
    ViewStage stage() {
        return scene.stages().get(stage);
    }

    List<Method<PointTransformer>> methods() {
        return topic.methods();
    }

    Method<PointTransformer> method() {
        return topic.method(choice().method());
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(choice().withMethod(topic.method(method).name()));
    }

    public void choose(ViewKind kind) {
        rearrange(choice().with(kind));
    }

    /**
     * @throws IllegalArgumentException if the number is not finite
     */
    public void set(ViewNumber which, double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException(
                    which.code() + " must be a finite number, got " + value);
        change(choice().with(which, value));
    }

    /** Judges each method by the house in a situation, in teaching order. */
    Map<String, Verdict.Kind> verdicts(ViewSituation situation) {
        var verdicts = new LinkedHashMap<String, Verdict.Kind>();
        for (Method<PointTransformer> each : topic.methods()) {
            ViewChoice choice = situation.in(choice()).withMethod(each.name());
            verdicts.put(
                    each.name(),
                    ViewScene.of(topic, choice)
                            .deviation()
                            .map(this::verdict)
                            .orElse(Verdict.Kind.REFUSED));
        }
        return verdicts;
    }

    private Verdict.Kind verdict(Deviation deviation) {
        if (topic.correct(deviation)) return Verdict.Kind.EXACT;
        return topic.usable(deviation) ? Verdict.Kind.DEGRADED : Verdict.Kind.WRONG;
    }

    /** Brings several numbers of a kind at once. */
    public void show(ViewSituation situation) {
        rearrange(situation.in(choice()));
        goTo(ViewStage.CoordinateSpace.PICTURE.ordinal());
    }

    /**
     * Turns what the stage shows: the viewpoint of a space with depth, otherwise the object or the
     * eye, as far as the kind of view can.
     *
     * @param right share of the house's width that it is dragged by
     * @param up share of the house's height
     */
    public void turn(double right, double up) {
        ViewChoice now = choice();
        if (stage().space().deep()) {
            change(now.with(now.viewpoint().turned(TURN * right, -TURN * up)));
            return;
        }
        double way = now.kind().spherical() ? -TURN : TURN;
        ViewChoice next = now;
        for (ViewNumber side : angle(now.kind(), true).stream().toList())
            next = next.with(side, wrapped(now.number(side) + way * right));
        for (ViewNumber over : angle(now.kind(), false).stream().toList())
            next = next.with(over, wrapped(now.number(over) - way * up));
        change(next);
    }

    /** Turns the viewpoint from which spaces with depth are drawn. */
    public void turnBy(double alphaDegrees, double betaDegrees) {
        change(choice().with(choice().viewpoint().turned(alphaDegrees, betaDegrees)));
    }

    private static double wrapped(double degrees) {
        return Math.IEEEremainder(degrees, 360);
    }

    /** The angle that a drag to the side, or one upward, changes; none where nothing turns. */
    private static Optional<ViewNumber> angle(ViewKind kind, boolean side) {
        return switch (kind) {
            case HOUSE -> Optional.of(side ? ViewNumber.ANGLE_Y : ViewNumber.TILT);
            case SPHERICAL_LEFT, SPHERICAL_RIGHT ->
                    Optional.of(side ? ViewNumber.THETA : ViewNumber.PHI);
            case TRIMETRIC -> Optional.of(side ? ViewNumber.ALPHA : ViewNumber.BETA);
            default -> Optional.empty();
        };
    }

    @Override
    protected void chosen(ViewChoice next) {
        scene = ViewScene.of(topic, next);
    }

    @Override
    public int last() {
        return scene.stages().size() - 1;
    }

    @Override
    public int step() {
        return stage;
    }

    @Override
    public void goTo(int step) {
        int next = within(step);
        if (next == stage) return;
        stage = next;
        tell();
    }
}
