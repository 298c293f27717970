package rasterlab.exercises.runner;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.marking.CaseTrial;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.SpeedFigures;

/** Puts a student's speed and error beside those of the topic's methods. */
final class FiguresRun {
    private final Exercise exercise;
    private final TopicGrading topic;
    private final Models models;

    FiguresRun(Exercise exercise, TopicGrading topic, Models models) {
        this.exercise = exercise;
        this.topic = topic;
        this.models = models;
    }

    /**
     * The figures; empty where nothing was measured.
     *
     * @param timing what was timed last
     * @param cases what the student answered
     */
    Optional<SpeedFigures> of(
            SpeedTrial.SpeedOutcome speed,
            TopicGrading.TimingInputs timing,
            Models.Model model,
            List<CaseTrial> cases) {
        List<TriedCall> judged =
                cases.stream()
                        .filter(FiguresRun::counts)
                        .flatMap(tried -> tried.calls().stream())
                        .toList();
        OptionalDouble error = error(judged);
        if (!speed.isKnown() || !speed.obstacle().isEmpty() || error.isEmpty())
            return Optional.empty();
        List<GradedCall> calls = judged.stream().map(TriedCall::call).toList();
        Object reference = models.instance(exercise, topic, model);
        return Optional.of(
                new SpeedFigures(
                        speed.ratio().get(),
                        speed.reference(),
                        error.getAsDouble(),
                        models.classics().classicsFor(exercise, topic, timing, reference, calls)));
    }

    /** Findings in hidden cases are not told, and hazards ask for more than accuracy. */
    private static boolean counts(CaseTrial tried) {
        return tried.one().kind() == Criterion.ACCURACY
                && tried.one().visibility() == Disclosure.OPEN;
    }

    private static OptionalDouble error(List<TriedCall> calls) {
        return calls.stream()
                .map(FiguresRun::error)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .max();
    }

    private static OptionalDouble error(TriedCall tried) {
        boolean answered =
                tried.answer()
                        .filter(one -> one.ending() == Answer.CallEnding.RETURNED)
                        .filter(one -> one.output().isPresent())
                        .isPresent();
        if (answered) return tried.call().error(tried.answer().get().output().get());
        return OptionalDouble.of(Double.POSITIVE_INFINITY);
    }
}
