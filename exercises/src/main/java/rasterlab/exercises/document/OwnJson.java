package rasterlab.exercises.document;

import com.fasterxml.jackson.annotation.JsonAutoDetect.Visibility;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;

/**
 * The one mapper of documents that one of our programs writes for another to read: answers of the
 * grading server, messages and parts of pictures in its data base, what the window keeps between
 * runs, and inputs and answers that formats write, to be looked into.
 *
 * <p>Nobody writes these by hand, so a mistake in one is a fault and not told by its place. Whoever
 * reads one that may be of another version or from another server says what happens then.
 */
public final class OwnJson {
    /** Reads only records that are whole, and writes what they hold, not what they compute. */
    public static final JsonMapper MAPPER =
            JsonMapper.builder()
                    .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
                    .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
                    .visibility(PropertyAccessor.IS_GETTER, Visibility.NONE)
                    .build();

    private OwnJson() {}
}
