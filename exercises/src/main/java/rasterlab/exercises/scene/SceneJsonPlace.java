package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.function.Function;
import rasterlab.exercises.json.JsonPlace;
import rasterlab.exercises.json.JsonText;
import rasterlab.exercises.json.NotJson;
import rasterlab.exercises.score.Phrase;

/** A place of a JSON text that knows its path; whatever is wrong there is refused with it. */
final class SceneJsonPlace extends JsonPlace<SceneJsonPlace> {
    /** The whole text. */
    private final String json;

    private final String path;

    private SceneJsonPlace(String json, String path, JsonNode node) {
        super(node);
        this.json = json;
        this.path = path;
    }

    static SceneJsonPlace root(String json) {
        try {
            return new SceneJsonPlace(json, "$", JsonText.treeWithEndlessNumbers(json));
        } catch (NotJson e) {
            throw new IllegalArgumentException("not JSON: " + e.phrase(), e);
        }
    }

    @Override
    protected SceneJsonPlace field(String name, JsonNode value) {
        return new SceneJsonPlace(json, path + "." + name, value);
    }

    @Override
    protected SceneJsonPlace member(int index, JsonNode value) {
        return new SceneJsonPlace(json, path + "[" + index + "]", value);
    }

    @Override
    protected SceneJsonPlace unknown(String name) {
        return at(cut(name));
    }

    @Override
    protected String listed(String... known) {
        return String.join(", ", known);
    }

    @Override
    protected String endless() {
        return endlessNumber(path, json);
    }

    /** This object, in which only the known fields may occur; none given: any. */
    SceneJsonPlace object(String... known) {
        requireObject(known);
        return this;
    }

    /** This place, which holds an object or could have held a scene's name. */
    SceneJsonPlace nameOrObject() {
        if (!isObject()) throw wrong("must be a scene's name or an object {…}, got " + shown());
        return this;
    }

    /** Reads so many numbers. */
    double[] numbers(int count, double least, double most) {
        List<SceneJsonPlace> members = members();
        if (members.size() != count)
            throw wrong("must have %d numbers, got %d".formatted(count, members.size()));
        return members.stream().mapToDouble(member -> member.number(least, most)).toArray();
    }

    /** This object as it stands, of which all numbers are finite. */
    String json() {
        object();
        requireFinite();
        return asJson();
    }

    private void requireFinite() {
        if (isEndless()) throw wrong("must be a finite number, got " + shown());
        if (isArray()) members().forEach(SceneJsonPlace::requireFinite);
        names().forEach(name -> at(name).requireFinite());
    }

    /** Calls {@code make} for this place; a refusal gets the path. */
    <T> T made(Function<SceneJsonPlace, T> make) {
        try {
            return make.apply(this);
        } catch (WrongPlace e) {
            throw e;
        } catch (IllegalArgumentException e) {
            throw wrong(e.getMessage());
        }
    }

    IllegalArgumentException wrong(String what) {
        return new WrongPlace(path + ": " + what);
    }

    @Override
    protected IllegalArgumentException wrong(Phrase what) {
        return wrong(what.toString());
    }

    private static final class WrongPlace extends IllegalArgumentException {
        private static final long serialVersionUID = 1;

        WrongPlace(String message) {
            super(message);
        }
    }
}
