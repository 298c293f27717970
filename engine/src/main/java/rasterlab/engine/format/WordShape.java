package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/** One word of several. */
record WordShape(List<String> words) implements Shape<String> {
    @Override
    public String read(ValueSource in) throws IOException {
        return in.word(words);
    }

    @Override
    public void write(String value, ValueSink out) throws IOException {
        out.text(value);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.name("enum");
        out.startArray();
        for (String word : words) out.text(word);
        out.endArray();
        out.endObject();
    }
}
