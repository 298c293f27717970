package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;

/**
 * Draws inputs by templates that take turns; the templates of one turn share the drawn numbers.
 *
 * @param turns at least one, each of at least one template
 * @param read makes an input of its JSON
 */
record Drawing<I>(
        NamedNumbers let, List<List<Template>> turns, Function<JsonNode, I> read, int[] drawn) {
    Drawing(NamedNumbers let, List<List<Template>> turns, Function<JsonNode, I> read) {
        this(let, turns, read, new int[1]);
    }

    /** The inputs of the next turn. */
    List<I> next(Random random) {
        Map<String, Long> numbers = let.draw(random);
        List<Template> turn = turns.get(drawn[0]++ % turns.size());
        return turn.stream().map(one -> read.apply(one.draw(random, numbers))).toList();
    }
}
