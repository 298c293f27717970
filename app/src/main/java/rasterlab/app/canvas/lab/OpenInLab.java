package rasterlab.app.canvas.lab;

import java.util.Optional;
import rasterlab.engine.raster.Plotted;
import rasterlab.exercises.predicting.HandedAnswers;

/** Shows an input in the tab of its topic, wherever in the window that is asked for. */
public interface OpenInLab {
    /**
     * Why no tab can show that hazard; empty where one can.
     *
     * @throws IllegalArgumentException if there is no such topic or hazard
     */
    Optional<NotShown> obstacleTo(String topic, String hazard);

    /**
     * Brings the topic's tab to the front with that hazard.
     *
     * @param method by which it is shown, where the tab has that method
     * @throws IllegalArgumentException if there is no such topic, hazard or method, or an obstacle
     */
    void showHazard(String topic, String hazard, String method);

    /** Why no tab can show inputs of that topic that are given as JSON; empty where one can. */
    Optional<NotShown> obstacleToInputs(String topic);

    /**
     * Brings the topic's tab to the front with that input.
     *
     * @param json an object, as {@code ./lab run} takes it
     * @param method by which it is shown; "" for the one that is chosen there
     * @param drawn what the user's program plotted, shown beside it; empty where that was right or
     *     is not known
     * @throws IllegalArgumentException if there is no such method, an obstacle, or naming the place
     *     where the input cannot be read
     */
    void showInput(String topic, String json, String method, Optional<Plotted> drawn);

    /** Whether a tab can hand in the input of that topic which it shows. */
    boolean handsIn(String topic);

    /**
     * Brings the topic's tab to the front, from which the input that is shown there can be handed
     * in for the exercise.
     *
     * @param exercise its id
     * @param json an input that it begins with; "" for the one that is shown there
     * @throws IllegalArgumentException naming the place where the input cannot be read
     */
    void showToHandIn(String exercise, String topic, String json);

    /** Whether a tab can ask for steps of methods of that topic. */
    boolean asksSteps(String topic);

    /**
     * Brings the topic's tab to the front, which asks for the steps of an exercise's sheet and from
     * which it can be handed in.
     *
     * @param exercise its id
     * @param begun the sheet with the answers so far
     */
    void answerSteps(String exercise, HandedAnswers begun);

    /** Why no tab can run the user's own program on that topic; empty where one can. */
    Optional<NotShown> obstacleToOwn(String topic);

    /**
     * Brings the topic's tab to the front with the user's own program as its method.
     *
     * @param json an object, as {@code ./lab run} takes it; "" for the input that is shown there
     * @param beside a method that it is compared with; "" for a right one
     * @throws IllegalArgumentException if there is no such method, an obstacle, or naming the place
     *     where the input cannot be read
     */
    void showOwn(String topic, String json, String beside);
}
