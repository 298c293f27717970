package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.topic.CaseRules;

/**
 * A report in one language, with the fields that a submission has in the HTTP API, as far as they
 * concern the exercise and the report.
 *
 * @param verdict its code
 * @param speed the point on the topic's chart; empty where no speed was measured
 */
public record PublishedReport(
        String exercise,
        String revision,
        String verdict,
        PublishedPoints points,
        List<PublishedCase> cases,
        List<PublishedDiagnostic> diagnostics,
        String isolation,
        Optional<PublishedSpeed> speed)
        implements PublishedPart {
    public PublishedReport {
        cases = List.copyOf(cases);
        diagnostics = List.copyOf(diagnostics);
    }

    /**
     * A report in words of that language.
     *
     * @param language such as "ru"
     * @param url of a case's picture
     */
    public static PublishedReport of(
            Exercise exercise,
            Report report,
            String language,
            BiFunction<CaseReport, CasePicture, String> url) {
        return new PublishedReport(
                exercise.id(),
                exercise.revision(),
                report.verdict().code(),
                PublishedPoints.of(report.points()),
                report.cases().stream().map(one -> judged(exercise, one, language, url)).toList(),
                report.diagnostics().stream()
                        .map(one -> PublishedDiagnostic.of(one, language))
                        .toList(),
                report.isolation(),
                report.figures().map(one -> PublishedSpeed.of(exercise.topic(), one)));
    }

    private static PublishedCase judged(
            Exercise exercise,
            CaseReport one,
            String language,
            BiFunction<CaseReport, CasePicture, String> url) {
        PublishedCase judged =
                PublishedCase.of(
                        one,
                        language,
                        exercise.caseTitle(one.name(), language),
                        picture -> url.apply(one, picture));
        return CaseRules.of(exercise, one.name())
                .map(right -> judged.under(right, language))
                .orElse(judged);
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeStringField("exercise", exercise);
        out.writeStringField("revision", revision);
        out.writeStringField("verdict", verdict);
        out.writeFieldName("points");
        points.write(out);
        out.writeArrayFieldStart("cases");
        for (PublishedCase one : cases) one.write(out);
        out.writeEndArray();
        out.writeArrayFieldStart("diagnostics");
        for (PublishedDiagnostic one : diagnostics) one.write(out);
        out.writeEndArray();
        out.writeStringField("isolation", isolation);
        out.writeFieldName("speed");
        if (speed.isPresent()) speed.get().write(out);
        else out.writeNull();
        out.writeEndObject();
    }
}
