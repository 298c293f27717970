package rasterlab.exercises.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.format.Doubles;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Misfit;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSource;

/** Reads shapes at the places of a text, which refuse in words of their own. */
final class PlacedValues<P extends JsonPlace<P>> implements ValueSource {
    private final P place;

    PlacedValues(P place) {
        this.place = place;
    }

    @Override
    public boolean startsObject() {
        return place.isObject();
    }

    @Override
    public boolean startsArray() {
        return place.isArray();
    }

    @Override
    public boolean startsText() {
        return place.isText();
    }

    @Override
    public boolean isNull() {
        return place.isNull();
    }

    @Override
    public Given object(List<Field<?>> fields) throws IOException {
        place.requireObject(fields.stream().map(Field::name).toArray(String[]::new));
        return openObject(fields);
    }

    @Override
    public Given openObject(List<Field<?>> fields) throws IOException {
        place.requireObject();
        var given = new Given();
        for (Field<?> field : fields) {
            if (!place.has(field.name()) && !field.required()) continue;
            P value = place.required(field.name());
            given.put(field, field.shape().read(new PlacedValues<>(value)));
        }
        for (String name : place.names()) if (!given.has(name)) given.putUnknown(name);
        return given;
    }

    @Override
    public <T> List<T> list(String what, Shape<T> item, int least, int most) throws IOException {
        List<P> members = place.members();
        if (members.size() < least || members.size() > most)
            throw misfit(
                    "expected an array of %d to %d %s, got %d"
                            .formatted(least, most, what, members.size()));
        var values = new ArrayList<T>();
        for (P member : members) values.add(item.read(new PlacedValues<>(member)));
        return values;
    }

    @Override
    public double[] numbers(int least, int most) throws IOException {
        return list("numbers", Shape.number(), least, most).stream()
                .mapToDouble(Double::doubleValue)
                .toArray();
    }

    @Override
    public double[] points(int dimension, int least, int most) throws IOException {
        var values = new Doubles();
        for (double[] point : list("points", Shape.numbers(dimension, dimension), least, most))
            for (double coordinate : point) values.add(coordinate);
        return values.toArray();
    }

    @Override
    public int[] wholes(int count) {
        return place.integers(count);
    }

    @Override
    public double number() {
        return place.number(-Double.MAX_VALUE, Double.MAX_VALUE);
    }

    @Override
    public double numberFrom(double least, double most) {
        return place.number(least, most);
    }

    @Override
    public double numberAbove(double least, double most) {
        double value = place.number(least, most);
        if (value == least) throw misfit("expected a number above " + least + ", got " + value);
        return value;
    }

    @Override
    public int whole(int least, int most) {
        return place.integer(least, most);
    }

    @Override
    public boolean flag() {
        return place.flag();
    }

    @Override
    public String word(List<String> allowed) {
        String text = place.text();
        if (!allowed.contains(text)) throw place.notOneOf(allowed, text);
        return text;
    }

    @Override
    public String text(String expected, int least, int most) {
        String text = place.text();
        if (text.length() < least || text.length() > most) throw misfit("expected " + expected);
        return text;
    }

    @Override
    public Misfit misfit(String reason) {
        return new Misfit(reason);
    }
}
