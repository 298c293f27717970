package rasterlab.app.hazard;

import java.awt.Dimension;

/**
 * The picture of a hazard's right answer: its bytes stand on the page once, in the first cell that
 * shows it, and all others refer to them.
 */
final class RightAnswer {
    /** Stands for a picture that cannot be drawn. */
    static final RightAnswer NONE = new RightAnswer("", new Dimension());

    private final String data;
    private final Dimension size;
    private boolean shown;

    /**
     * @param data the picture as an address; "" for none
     * @param size in pixels
     */
    RightAnswer(String data, Dimension size) {
        this.data = data;
        this.size = size;
    }

    Dimension size() {
        return size;
    }

    /**
     * The picture in one more cell.
     *
     * @param id of its bytes on the page
     * @param said what it shows, escaped
     * @param otherwise what stands there where there is none
     */
    String html(String id, String said, String otherwise) {
        if (data.isEmpty()) return otherwise;
        String inside =
                shown
                        ? "<use href=\"#%s\"/>".formatted(id)
                        : "<image id=\"%s\" width=\"%d\" height=\"%d\" href=\"%s\"/>"
                                .formatted(id, size.width, size.height, data);
        shown = true;
        return "<svg role=\"img\" aria-label=\"%s\" width=\"%d\" viewBox=\"0 0 %d %d\">%s</svg>\n"
                .formatted(said, size.width, size.width, size.height, inside);
    }
}
