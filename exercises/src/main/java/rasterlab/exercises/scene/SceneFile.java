package rasterlab.exercises.scene;

/**
 * The contents of a scene file.
 *
 * <p>{@code {"version": 1, "topic": "line", "method": "bresenham", "input": {…}}} is a {@link
 * MethodCase}, which may have {@code "drawn"}, the pixels of a student's method, and {@code
 * "drawnCut"}, true where those are only the first; {@code {"version": 1, "scene": "vase",
 * "camera": {…}, "look": {…}}} is a {@link SceneView}. Both are read strictly: an unknown field, a
 * wrong type and a value out of range are refused with the path of the place, such as {@code
 * $.scene.faces[2].corners[0]}.
 */
public sealed interface SceneFile permits MethodCase, SceneView {
    /** The mark that some editors begin a text in UTF-8 with. */
    String BYTE_ORDER_MARK = "\uFEFF";

    /** The only version there is. */
    int VERSION = 1;

    /** The most characters of a file: 64 Mi. */
    int LONGEST = 64 << 20;

    /**
     * @param json the whole text; a byte-order mark that it begins with is passed over
     * @throws IllegalArgumentException naming the path, what is there and what is allowed
     */
    static SceneFile read(String json) {
        if (json.length() > LONGEST)
            throw new IllegalArgumentException(
                    "a scene file has at most %d characters, got %d"
                            .formatted(LONGEST, json.length()));
        String text = json.startsWith(BYTE_ORDER_MARK) ? json.substring(1) : json;
        if (text.isBlank())
            throw new IllegalArgumentException("the file is empty; a scene file is an object {…}");
        SceneJsonPlace file = SceneJsonPlace.root(text);
        return file.has("topic") ? CaseJson.read(file) : ViewJson.read(file);
    }
}
