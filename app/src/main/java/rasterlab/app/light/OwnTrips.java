package rasterlab.app.light;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.ColorConverter;
import rasterlab.contract.ColorModel;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.WrongLength;

/**
 * How colours come back from all models by the user's own program, which is asked on a thread of
 * this class's own.
 */
public final class OwnTrips implements AutoCloseable {
    /**
     * The answers to one colour.
     *
     * @param errors as {@link ColorChoice#roundTrips} has them; none where the program gives no
     *     answer
     * @param refusal why there is none, in English; "" otherwise
     */
    public record Trips(ColorChoice color, Map<ColorModel, Double> errors, String refusal) {
        /** Why there is no answer, in words; "" where there is one. */
        public String refusalIn(Language language) {
            if (refusal.isEmpty()) return "";
            return OwnWords.refusal(OwnMethods.NAME, refusal, language).orElse("");
        }
    }

    private final LatestOnly<ColorChoice, Trips> trips;
    private Optional<ColorChoice> asked = Optional.empty();
    private Optional<Trips> newest = Optional.empty();

    /**
     * @param events runs what it is given on the one thread that uses this, in order
     * @param onFailure told what asking threw, on any thread
     * @param changed run when an answer is there
     */
    OwnTrips(OwnMethods own, Executor events, Consumer<Throwable> onFailure, Runnable changed) {
        Topic<ColorConverter, ?, ?> topic = own.in(new ColorTopic());
        trips =
                new LatestOnly<>(
                        "own colours",
                        (color, cancelled) -> trips(topic, color),
                        (color, answer) ->
                                events.execute(
                                        () -> {
                                            newest = Optional.of(answer);
                                            changed.run();
                                        }),
                        onFailure);
    }

    private static Trips trips(Topic<ColorConverter, ?, ?> topic, ColorChoice color) {
        ColorConverter program = topic.method(OwnMethods.NAME).implementation();
        try {
            return new Trips(color, color.roundTrips(measured(program)), "");
        } catch (NoAnswer none) {
            return without(color, none);
        } catch (WrongLength length) {
            return without(color, OwnMethods.misshapen(length));
        }
    }

    private static Trips without(ColorChoice color, NoAnswer why) {
        return new Trips(color, Map.of(), why.getMessage());
    }

    /** The program, whose answers have the right length. */
    private static ColorConverter measured(ColorConverter program) {
        return (from, components, to) -> {
            double[] answer = program.convert(from, components, to);
            WrongLength.require(to.size(), answer.length, "numbers");
            return answer;
        };
    }

    /** The colour that came back; empty until it is found, which this call starts. */
    Optional<Trips> of(ColorChoice color) {
        if (asked.filter(color::equals).isEmpty()) {
            asked = Optional.of(color);
            trips.ask(color);
        }
        return newest.filter(trip -> trip.color().equals(color));
    }

    /** Asks again: the program may be another by now. */
    void forget() {
        asked = Optional.empty();
        newest = Optional.empty();
    }

    /** Waits until what was asked so far is answered. Any other thread. */
    void settle() throws InterruptedException {
        trips.settle();
    }

    /** Ends the thread. */
    @Override
    public void close() {
        trips.close();
    }
}
