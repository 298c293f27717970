package rasterlab.exercises.searching;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import rasterlab.exercises.searching.TreeParts.TreePlace;

/** Makes an input simpler as long as it fails: fewer items, then simpler numbers. */
final class TreeShrinking {
    private final Predicate<JsonNode> fails;
    private final Consumer<JsonNode> simpler;
    private final BooleanSupplier stop;
    private JsonNode best;

    /**
     * @param fails whether an input fails as the first one does
     * @param simpler told each input that is simpler and fails
     * @param stop asked before each trial
     */
    TreeShrinking(Predicate<JsonNode> fails, Consumer<JsonNode> simpler, BooleanSupplier stop) {
        this.fails = fails;
        this.simpler = simpler;
        this.stop = stop;
    }

    /** An input of which no item can be left out and no number made simpler, if there was time. */
    JsonNode shrunk(JsonNode input) {
        best = input;
        boolean changed = true;
        while (changed && !stop.getAsBoolean()) changed = fewerFields() | fewerItems() | numbers();
        return best;
    }

    private boolean taken(JsonNode candidate) {
        if (stop.getAsBoolean() || !fails.test(candidate)) return false;
        best = candidate;
        simpler.accept(best);
        return true;
    }

    private boolean fewerFields() {
        boolean changed = false;
        var names = new ArrayList<String>();
        best.fieldNames().forEachRemaining(names::add);
        for (String name : names) {
            ObjectNode candidate = best.deepCopy();
            candidate.remove(name);
            changed |= taken(candidate);
        }
        return changed;
    }

    private boolean fewerItems() {
        boolean changed = false;
        for (int at = 0; at < new TreeParts(best).arrays().size(); at++)
            for (int size = array(best, at).size() / 2; size > 0; size /= 2)
                changed |= fewerItems(at, size);
        return changed;
    }

    private static ArrayNode array(JsonNode tree, int at) {
        List<ArrayNode> arrays = new TreeParts(tree).arrays();
        return arrays.get(Math.min(at, arrays.size() - 1));
    }

    private boolean fewerItems(int at, int size) {
        boolean changed = false;
        for (int from = array(best, at).size() - size; from >= 0; from -= size) {
            if (stop.getAsBoolean()) return changed;
            JsonNode candidate = best.deepCopy();
            ArrayNode array = array(candidate, at);
            if (from + size > array.size()) continue;
            for (int i = 0; i < size; i++) array.remove(from);
            changed |= taken(candidate);
        }
        return changed;
    }

    private boolean numbers() {
        boolean changed = false;
        for (int i = 0; i < new TreeParts(best).numbers().size(); i++) changed |= number(i);
        return changed;
    }

    private boolean number(int at) {
        double old = new TreeParts(best).numbers().get(at).value().doubleValue();
        for (double candidate : candidates(old)) {
            if (stop.getAsBoolean()) return false;
            if (!(weight(candidate) < weight(old))) continue;
            if (taken(with(at, old, candidate, false)) || taken(with(at, old, candidate, true)))
                return true;
        }
        return false;
    }

    /**
     * @param all whether all equal numbers change with it
     */
    private JsonNode with(int at, double old, double number, boolean all) {
        JsonNode candidate = best.deepCopy();
        List<TreePlace> numbers = new TreeParts(candidate).numbers();
        for (int i = 0; i < numbers.size(); i++)
            if (i == at || all && numbers.get(i).value().doubleValue() == old)
                numbers.get(i).put(TreeParts.number(number));
        return candidate;
    }

    private static double[] candidates(double number) {
        double size = Math.abs(number);
        return new double[] {
            0,
            1,
            -1,
            2,
            10,
            Math.rint(number / 4),
            Math.rint(number / 2),
            number - Math.signum(number),
            size,
            Math.rint(number),
            Math.rint(number * 8) / 8,
            Math.signum(number) * Math.scalb(1.0, Math.getExponent(size)),
        };
    }

    /** A measure that is least for small whole numbers and grows with what is written. */
    private static double weight(double number) {
        boolean negative = number < 0 || 1 / number < 0;
        if (number == Math.rint(number) && Math.abs(number) < 1e6)
            return 2 * Math.abs(number) + (negative ? 1 : 0);
        return 1e7 + Double.toString(number).length();
    }
}
