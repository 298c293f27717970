package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.marking.CaseTrial;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.topic.TopicGradings;

/** Marks a method that runs here, without a child, on the cases of an exercise. */
record MarkedMethod(Exercise exercise, Marking marking) {
    static MarkedMethod of(Exercise exercise, LineRasterizer method, CaseSelection selection) {
        Marking marking = new Marking(exercise);
        for (Case one : exercise.cases())
            if (selection.hidden() || one.visibility() == Disclosure.OPEN)
                marking.put(tried(exercise, one, method, selection.seed()));
        return new MarkedMethod(exercise, marking);
    }

    private static CaseTrial tried(Exercise exercise, Case one, LineRasterizer method, long seed) {
        List<GradedCall> calls = TopicGradings.named("line").calls(one, exercise.tolerance(), seed);
        List<TriedCall> tried = new ArrayList<>();
        for (GradedCall call : calls) tried.add(TriedCall.answered(call, answer(method, call)));
        return CaseTrial.tried(one, tried);
    }

    private static Answer answer(LineRasterizer method, GradedCall call) {
        try {
            return answer(Answer.CallEnding.RETURNED, call.recorded(method, call.caps().items()));
        } catch (LimitReached reached) {
            return answer(Answer.CallEnding.CUT, reached.recorded());
        } catch (IllegalArgumentException | ArithmeticException e) {
            return Answer.threw(e.getClass().getName(), e.getMessage(), 0, "");
        }
    }

    private static Answer answer(Answer.CallEnding ending, Object drawn) {
        long items = drawn instanceof PixelRecording pixels ? pixels.size() : 1;
        return Answer.with(ending, drawn, items, "", "");
    }

    /** Points for accuracy and stability together. */
    int points() {
        return points(List.of(Criterion.values()));
    }

    int accuracy() {
        return points(List.of(Criterion.ACCURACY));
    }

    private int points(List<Criterion> kinds) {
        return exercise.cases().stream()
                .filter(one -> kinds.contains(one.kind()))
                .filter(one -> marking.paying().contains(one.name()))
                .mapToInt(Case::points)
                .sum();
    }

    List<String> failed() {
        return exercise.cases().stream()
                .map(Case::name)
                .filter(name -> !marking.paying().contains(name))
                .toList();
    }

    /** The cases that failed, of those given. */
    List<String> failed(List<Case> cases) {
        List<String> names = cases.stream().map(Case::name).toList();
        return failed().stream().filter(names::contains).toList();
    }

    String shared() {
        return marking.shared().toString();
    }
}
