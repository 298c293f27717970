package rasterlab.tests.bench.grader;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The part of a result that does not depend on when and where it was graded.
 *
 * @param accuracy points
 * @param stability points
 */
record GradedOutcome(String verdict, int accuracy, int stability) {
    /** The outcome in a submission of the API; one that is not graded yet has no verdict. */
    static GradedOutcome of(JsonNode submission) {
        JsonNode points = submission.path("points");
        return new GradedOutcome(
                submission.path("verdict").asText("none"),
                points.path("accuracy").asInt(),
                points.path("stability").asInt());
    }

    /**
     * A line for each submission whose outcome is another one than expected, or is missing.
     *
     * @param expected by the id of the submission, as is {@code found}
     */
    static List<String> differences(
            Map<String, GradedOutcome> expected, Map<String, GradedOutcome> found) {
        var lines = new ArrayList<String>();
        new TreeMap<>(expected)
                .forEach(
                        (id, one) -> {
                            GradedOutcome other = found.get(id);
                            if (!one.equals(other))
                                lines.add(
                                        id
                                                + ": "
                                                + one.text()
                                                + " ≠ "
                                                + (other == null ? "-" : other.text()));
                        });
        return lines;
    }

    /** The verdict with the points of accuracy and of stability. */
    String text() {
        return verdict + " " + accuracy + " + " + stability;
    }
}
