package rasterlab.app.spline;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurveFlattener;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.Disclosure;

/** Says what a program for an exercise on curves can be asked for. */
record OwnCurve(Exercise exercise) {
    /** Steps between points at given t, where a program can be asked for nothing else. */
    private static final int STEPS = 24;

    /** The sampling that is shown, or one that the exercise's contract can answer. */
    Sampling sampling(Sampling shown) {
        String contract = exercise.contract().orElse("");
        if (shown.isFlat() && contract.equals(CurveEvaluator.class.getSimpleName()))
            return Sampling.equal(STEPS);
        if (!shown.isFlat() && contract.equals(CurveFlattener.class.getSimpleName()))
            return Sampling.flat(CurveLabModel.FIRST_FLATNESS);
        return shown;
    }

    /** The form that is shown, or one of those that the exercise's open cases are about. */
    CurveForm form(CurveForm shown) {
        Set<String> kinds =
                exercise.cases().stream()
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .map(one -> kind(one.input()))
                        .filter(kind -> !kind.isEmpty())
                        .collect(Collectors.toSet());
        if (kinds.isEmpty() || kinds.contains(shown.kind().code())) return shown;
        return Stream.of(CurveForm.values())
                .filter(form -> kinds.contains(form.kind().code()))
                .findFirst()
                .orElse(shown);
    }

    /** The kind of the curve that a case gives; "" where it gives none. */
    private static String kind(String input) {
        try {
            return new JsonMapper().readTree(input).at("/given/kind").asText("");
        } catch (JsonProcessingException noJson) {
            return "";
        }
    }
}
