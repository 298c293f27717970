package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.cli.run.TopicRun.Answer;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;

/** Which points lie inside, in the field {@code inside}: true or false for each point. */
final class MembershipAnswer {
    private MembershipAnswer() {}

    /**
     * What a method says of all points.
     *
     * @throws Complaint as {@link Watch#call}
     */
    static Answer of(Watch watch, String method, Points points, Membership.Judge judge) {
        return of(watch, method, points, judge, json -> {});
    }

    /**
     * The same with the steps to it.
     *
     * @param steps writes what {@code judge} recorded
     */
    static Answer of(
            Watch watch, String method, Points points, Membership.Judge judge, Answer steps) {
        Membership inside = watch.call(method, () -> new Membership(points, points.size(), judge));
        return json -> {
            write(json, inside);
            steps.write(json);
        };
    }

    private static void write(JsonGenerator json, Membership inside) throws IOException {
        json.writeArrayFieldStart("inside");
        for (int i = 0; i < inside.size(); i++) json.writeBoolean(inside.inside(i));
        json.writeEndArray();
    }
}
