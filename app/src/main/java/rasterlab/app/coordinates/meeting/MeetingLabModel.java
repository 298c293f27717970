package rasterlab.app.coordinates.meeting;

import java.util.List;
import java.util.Optional;
import rasterlab.app.coordinates.figure.ChoiceModel;
import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.geometry.meeting.PlaneAndLines;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;

/** The lab of a line that meets a plane, without its window. */
public final class MeetingLabModel extends ChoiceModel<MeetingChoice> {
    /** The two points that can be moved. */
    enum MeetingGrip {
        FROM,
        THROUGH
    }

    private final LinePlaneTopic topic = new LinePlaneTopic();
    private MeetingScene scene = MeetingScene.of(topic, choice());
    private SideView view = SideView.of(choice().plane(), choice().line());
    private int viewed = arrangement();

    public MeetingLabModel() {
        super(MeetingChoice.first());
    }

    MeetingScene scene() {
        return scene;
    }

    /** Stays while points are moved. */
    SideView view() {
        return view;
    }

    /** The shell command that asks the same; empty where no command can. */
    public Optional<String> command() {
        return MeetingCommand.of(choice());
    }

    List<Method<LinePlane>> methods() {
        return topic.methods();
    }

    Method<LinePlane> method() {
        return topic.method(choice().method());
    }

    List<Hazard<PlaneAndLines>> hazards() {
        return topic.hazards();
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public void chooseMethod(String method) {
        change(choice().withMethod(topic.method(method).name()));
    }

    /** Shows the plane and the first of the lines. */
    public void show(PlaneAndLines input) {
        rearrange(choice().with(input));
    }

    /** Moves a point to a place of the picture; onto the other point it does not go. */
    void move(MeetingGrip grip, double x, double y) {
        Line old = choice().line();
        Vector from = grip == MeetingGrip.FROM ? view.point(x, y) : old.from();
        Vector through = grip == MeetingGrip.THROUGH ? view.point(x, y) : old.through();
        if (through.minus(from).length() > 0) change(choice().with(new Line(from, through)));
    }

    @Override
    protected void chosen(MeetingChoice next) {
        scene = MeetingScene.of(topic, next);
        if (viewed == arrangement()) return;
        viewed = arrangement();
        view = SideView.of(next.plane(), next.line());
    }
}
