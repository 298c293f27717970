package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import rasterlab.exercises.predicting.Question;

/**
 * An answer that was given.
 *
 * @param right as it was judged; a click in a plane is judged less strictly than numbers
 */
record AnsweredQuestion(Question question, JsonNode answer, boolean right) {}
