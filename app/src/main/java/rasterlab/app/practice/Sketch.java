package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;

/** Draws the questions on one topic's steps. */
interface Sketch {
    Board of(Walked walked);

    /**
     * How far a walk has gone.
     *
     * @param input of the walk
     * @param steps that are made
     * @param given of the step that is asked for; empty where the walk rests
     * @param wrong the answer that was given in place of the newest step, if it was wrong
     */
    record Walked(JsonNode input, List<JsonNode> steps, JsonNode given, Optional<JsonNode> wrong) {
        public Walked {
            steps = List.copyOf(steps);
        }

        /** The look of a step; the newest is told apart. */
        Board.FigureLook look(int step) {
            return step == steps.size() - 1 ? Board.FigureLook.NEWEST : Board.FigureLook.DONE;
        }
    }
}
