package rasterlab.exercises.runner;

import org.junit.jupiter.api.Test;
import rasterlab.exercises.Catalogue;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Sources;
import rasterlab.exercises.score.*;

class JudgeTest {
    @Test
    void tmp() throws Exception {
        long t0 = System.nanoTime();
        try (Judge judge = Judge.start(JudgeSettings.defaults())) {
            Exercise exercise = Catalogue.builtIn().named("line-bresenham");
            System.out.println(judge.isolation() + " " + exercise.revision());
            for (String s :
                    new String[] {
                        Sources.RIGHT,
                        Sources.RIGHT,
                        Sources.RIGHT,
                        Sources.NAIVE_TEXTBOOK,
                        Sources.BRESENHAM_TEXTBOOK,
                        exercise.starter(),
                        Sources.method("while(true);")
                    }) {
                long t = System.nanoTime();
                Report r = judge.grade(exercise, s, CaseSelection.all(42), c -> {});
                System.out.println((System.nanoTime() - t) / 1e6 + " ms " + (t - t0) / 1e6);
                System.out.println(
                        r.verdict() + " " + r.points() + " " + r.nanosPerItem() + r.diagnostics());
                for (CaseReport c : r.cases())
                    System.out.println(
                            "  "
                                    + c.name()
                                    + " "
                                    + c.verdict()
                                    + " "
                                    + c.points()
                                    + "/"
                                    + c.of()
                                    + " "
                                    + c.message()
                                    + " "
                                    + c.scene());
            }
        }
    }
}
