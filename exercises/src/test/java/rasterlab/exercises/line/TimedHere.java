package rasterlab.exercises.line;

import java.util.Optional;
import java.util.Random;
import java.util.Set;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.TimingInputs;
import rasterlab.exercises.TopicGrading.Timings;
import rasterlab.exercises.child.ItemSum;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.topic.TopicGradings;

/** Timed answers of a method that runs here, without a child. */
final class TimedHere {
    private TimedHere() {}

    /** Whether the answers are right but for mistakes that lost their points. */
    static boolean isPaid(Exercise exercise, Marking marking, LineRasterizer method) {
        Set<String> charged = marking.charged();
        Timings timings =
                TopicGradings.named("line").timings(exercise, new Random(3), marking.uncharged());
        for (int round = 0; round < 2; round++) {
            TimingInputs timing = timings.next();
            boolean paid =
                    timing.mistakes(answers(timing, method))
                            .filter(charged::containsAll)
                            .isPresent();
            if (!paid) return false;
        }
        return true;
    }

    /** The answer that a child would send. */
    static TopicGrading.TimedAnswers answers(TimingInputs timing, LineRasterizer method) {
        ItemSum sum = new ItemSum();
        for (int i = 0; i < timing.inputs(); i++) {
            PixelRecording drawn;
            try {
                drawn = (PixelRecording) timing.recorded(i, method);
            } catch (LimitReached endless) {
                drawn = (PixelRecording) endless.recorded();
            } catch (IllegalArgumentException | ArithmeticException refused) {
                drawn = new PixelRecording(1);
            }
            for (int k = 0; k < drawn.size(); k++) sum.plot(drawn.x(k), drawn.y(k));
        }
        return new TopicGrading.TimedAnswers(sum.count(), sum.sum(), Optional.empty());
    }
}
