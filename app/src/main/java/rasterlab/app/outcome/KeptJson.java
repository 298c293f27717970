package rasterlab.app.outcome;

import com.fasterxml.jackson.annotation.JsonAutoDetect.Visibility;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.datatype.jdk8.Jdk8Module;
import rasterlab.exercises.document.OwnJson;

/** Records in files that the window keeps between runs. Takes long to load. */
public final class KeptJson {
    /** Writes what records hold, not what they compute; reads only what is whole. */
    public static final ObjectMapper MAPPER =
            OwnJson.MAPPER
                    .rebuild()
                    .addModule(new Jdk8Module())
                    .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
                    .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                    .visibility(PropertyAccessor.GETTER, Visibility.NONE)
                    .visibility(PropertyAccessor.FIELD, Visibility.ANY)
                    .build();

    private KeptJson() {}
}
