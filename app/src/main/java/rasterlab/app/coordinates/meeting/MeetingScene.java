package rasterlab.app.coordinates.meeting;

import java.util.List;
import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.geometry.meeting.Meetings;
import rasterlab.engine.geometry.meeting.PlaneAndLines;
import rasterlab.engine.study.Method;

/**
 * The answers of all methods for one line and one plane.
 *
 * @param exact the right μ; NaN where there is none, or none within doubles
 * @param answers in the methods' order
 */
record MeetingScene(MeetingChoice choice, double exact, List<MeetingAnswer> answers) {
    /**
     * @param mu not finite where the method says nothing that is a number
     * @param refusal what it said when it refused, in English; "" otherwise
     * @param right whether it is the right μ, but for rounding, or the right refusal
     */
    record MeetingAnswer(String method, double mu, String refusal, boolean right) {
        boolean refused() {
            return !refusal.isEmpty();
        }
    }

    MeetingScene {
        answers = List.copyOf(answers);
    }

    static MeetingScene of(LinePlaneTopic topic, MeetingChoice choice) {
        PlaneAndLines input = choice.input();
        Meetings exact = topic.exact(input, 1);
        List<MeetingAnswer> answers =
                topic.methods().stream().map(each -> answer(topic, each, input, exact)).toList();
        return new MeetingScene(choice, exact.mu(0), answers);
    }

    private static MeetingAnswer answer(
            LinePlaneTopic topic, Method<LinePlane> method, PlaneAndLines input, Meetings exact) {
        try {
            Meetings said = topic.record(method.implementation(), input, 1);
            boolean right = topic.correct(topic.compare(input, exact, said));
            boolean number = Double.isFinite(said.mu(0));
            return new MeetingAnswer(method.name(), said.mu(0), "", right && number);
        } catch (IllegalArgumentException refused) {
            boolean right = Double.isNaN(exact.mu(0));
            return new MeetingAnswer(method.name(), Double.NaN, refused.getMessage(), right);
        }
    }

    /** The answer of the chosen method. */
    MeetingAnswer chosen() {
        return answers.stream()
                .filter(each -> each.method().equals(choice.method()))
                .findFirst()
                .orElseThrow();
    }
}
