package rasterlab.app.canvas;

/** Shows questions on the next step of a method in place of the lab that lies within it. */
public interface StepQuestions {
    /**
     * Asks for steps of a topic's method.
     *
     * @param topic one whose methods record steps
     */
    void ask(String topic);
}
