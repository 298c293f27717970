package rasterlab.exercises.searching;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.IntNode;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.json.JsonSink;
import rasterlab.exercises.json.StrictJson;
import rasterlab.exercises.searching.TreeParts.TreePlace;

/** Makes inputs of a topic of trees, and trees of inputs. */
final class SearchedInputs<C, I, O> {
    /** Numbers of an input; larger ones of a study are left out. */
    private static final int MOST_LEAVES = 400;

    private static final int MOST_OF_STUDY = 24;
    private static final int MOST_LOOKED_AT = 2000;

    /** Items that are left of an array. */
    private static final int FEW = 6;

    /** Arrays that cannot be cut: after so many no other is tried. */
    private static final int MOST_UNCUT = 3;

    private final Topic<C, I, O> topic;
    private final Format<C, I, O> format;
    private final Call<C> call;
    private int uncut;

    SearchedInputs(Topic<C, I, O> topic, String method, C implementation) {
        this.topic = topic;
        format = topic.format();
        call = new Call<>(method, implementation, false);
    }

    /** An input as {@code ./lab run} would take it; empty where it refuses it. */
    Optional<I> read(JsonNode tree) {
        byte[] text = tree.toString().getBytes(StandardCharsets.UTF_8);
        try {
            Given given = StrictJson.read(text, text.length, format.input(), format.open());
            I input = format.read(given);
            format.prepared(call, input);
            return Optional.of(input);
        } catch (IllegalArgumentException | ArithmeticException refused) {
            return Optional.empty();
        } catch (RuntimeException invalid) {
            // an invalid input, or numbers that the topic's own arithmetic cannot take
            return Optional.empty();
        }
    }

    /**
     * Draws an input from the topic's description; empty where its fields do not go together.
     *
     * @param calm whether numbers of a usual size are wanted
     */
    Optional<JsonNode> drawn(Random random, boolean calm) {
        try {
            var source = new DrawnSource(random, calm);
            List<List<Field<?>>> forms = format.forms();
            int form = forms.size() == 1 ? 0 : random.nextInt(forms.size());
            Given given =
                    format.open()
                            ? source.openObject(forms.get(form))
                            : source.object(forms.get(form));
            return Optional.of(tree(format.read(given)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (RuntimeException refused) {
            return Optional.empty();
        }
    }

    /** Ordinary inputs: some of the topic's study, cut to few items where they allow that. */
    List<JsonNode> ofStudy() {
        var all = new ArrayList<I>();
        for (Workload<I> workload : topic.workloads())
            for (I input : workload.inputs())
                for (I single : format.singles(input))
                    if (all.size() < MOST_LOOKED_AT) all.add(single);
        var trees = new ArrayList<JsonNode>();
        int step = Math.max(1, all.size() / MOST_OF_STUDY);
        for (int i = 0; i < all.size(); i += step) {
            JsonNode tree = treeOrNull(all.get(i));
            if (tree == null) continue;
            cut(tree);
            if (new TreeParts(tree).leaves().size() <= MOST_LEAVES) trees.add(tree);
        }
        return trees;
    }

    /**
     * Leaves the first few items of each array for which the rest is still an input, outer arrays
     * first and the last field first: it may refer to items of those before it, which then can go.
     * Twice, for references the other way.
     */
    private void cut(JsonNode tree) {
        for (int pass = 0; pass < 2; pass++) {
            uncut = 0;
            cut(tree, tree);
        }
    }

    private void cut(JsonNode tree, JsonNode part) {
        if (uncut == MOST_UNCUT) return;
        if (part instanceof ArrayNode array && array.size() > FEW) shorten(tree, array);
        var inner = new ArrayList<JsonNode>();
        part.forEach(inner::add);
        Collections.reverse(inner);
        for (JsonNode one : inner) if (one.isContainerNode()) cut(tree, one);
    }

    /** Leaves the first few items, or twice as many, and so on, whichever is an input first. */
    private void shorten(JsonNode tree, ArrayNode array) {
        var whole = new ArrayList<JsonNode>();
        array.forEach(whole::add);
        for (int few = FEW; few < whole.size() && few <= MOST_LEAVES; few *= 2) {
            array.removeAll();
            array.addAll(whole.subList(0, few));
            if (read(tree).isPresent()) return;
        }
        array.removeAll();
        array.addAll(whole.subList(0, FEW));
        if (fold(tree, array)) return;
        array.removeAll();
        array.addAll(whole);
        uncut++;
    }

    /**
     * Lets the whole numbers outside an array refer to the items that it has left, if that is an
     * input: what was item 8 of 6 becomes item 2.
     */
    private boolean fold(JsonNode tree, ArrayNode array) {
        Set<JsonNode> inside = Collections.newSetFromMap(new IdentityHashMap<>());
        for (TreePlace number : new TreeParts(array).numbers()) inside.add(number.parent());
        int items = array.size();
        List<TreePlace> beyond =
                new TreeParts(tree)
                        .numbers().stream()
                                .filter(number -> !inside.contains(number.parent()))
                                .filter(number -> number.value().isInt())
                                .filter(number -> number.value().intValue() >= items)
                                .toList();
        List<JsonNode> before = beyond.stream().map(TreePlace::value).toList();
        for (TreePlace number : beyond)
            number.put(IntNode.valueOf(number.value().intValue() % items));
        if (read(tree).isPresent()) return true;
        for (int i = 0; i < before.size(); i++) beyond.get(i).put(before.get(i));
        return false;
    }

    private JsonNode treeOrNull(I input) {
        try {
            return tree(input);
        } catch (IllegalArgumentException notTold) {
            return null;
        }
    }

    private JsonNode tree(I input) {
        var text = new StringWriter();
        try (JsonGenerator json = OwnJson.MAPPER.createGenerator(text)) {
            json.writeStartObject();
            format.writeInput(input, new JsonSink(json));
            json.writeEndObject();
            json.flush();
            return OwnJson.MAPPER.readTree(text.toString());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
