package rasterlab.app.canvas;

/** Shows an input in the tab of its topic, wherever in the window that is asked for. */
public interface OpenInLab {
    /** Whether there is a tab that shows that topic's hazards. */
    boolean showsHazards(String topic);

    /**
     * Brings the topic's tab to the front with that hazard.
     *
     * @param method by which it is shown
     * @throws IllegalArgumentException if there is no such tab, hazard or method
     */
    void showHazard(String topic, String hazard, String method);

    /** Whether there is a tab that shows any input of that topic. */
    boolean showsInputs(String topic);

    /**
     * Brings the topic's tab to the front with that input.
     *
     * @param json an object, as {@code ./lab run} takes it
     * @param method by which it is shown; "" for the one that is chosen there
     * @throws IllegalArgumentException if there is no such tab or method, or naming the place where
     *     the input cannot be read
     */
    void showInput(String topic, String json, String method);
}
