package rasterlab.app.canvas.lab;

/** Shows questions on the next step of a method in place of the lab that lies within it. */
public interface StepQuestions {
    /** The property that changes when questions come, or go. */
    String ASKING = "rasterlab.asking";

    /** Whether questions are shown, not the lab. */
    boolean isAsking();

    /**
     * Asks for steps of a topic's method.
     *
     * @param topic one whose methods record steps
     */
    void ask(String topic);
}
