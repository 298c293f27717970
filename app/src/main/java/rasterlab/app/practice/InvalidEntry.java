package rasterlab.app.practice;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;

/**
 * Says why something that was typed is not taken.
 *
 * @param missing the field of the answer that has no value; empty where a seed was typed that is
 *     none
 * @param typed the fields of the answer that have one
 */
record InvalidEntry(Optional<String> missing, ObjectNode typed) {}
