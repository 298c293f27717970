package rasterlab.app.signmap;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import rasterlab.engine.Topics;
import rasterlab.engine.signmap.SignMap;
import rasterlab.engine.signmap.SignSubject;

/** The maps of what is asked for by name. */
public final class SignMaps {
    private SignMaps() {}

    /** Everything that has sign maps: two predicates of geometry, then topics in their order. */
    public static List<SignSubject> subjects() {
        var all = new ArrayList<>(SignSubject.basic());
        Topics.all().forEach(topic -> SignSubject.of(topic).ifPresent(all::add));
        return all;
    }

    /**
     * @param asked each a predicate, for all its methods, or a predicate, a slash and a method;
     *     none: the orientation, in all its forms
     * @throws IllegalArgumentException for an unknown name; lists the known ones
     */
    public static List<SignMap> of(List<String> asked) {
        List<SignSubject> subjects = subjects();
        var maps = new ArrayList<SignMap>();
        for (String name : asked.isEmpty() ? List.of(subjects.get(0).name()) : asked) {
            String[] words = name.split("/", 2);
            SignSubject subject = SignSubject.find(words[0], subjects);
            if (words.length == 2) maps.add(subject.map(words[1]));
            else subject.methods().forEach(method -> maps.add(subject.map(method)));
        }
        return maps;
    }

    /** The maps of one topic's methods, where it has such. */
    public static Optional<SignSubject> ofTopic(String topic) {
        return SignSubject.of(Topics.named(topic));
    }

    /** The counts, as comma-separated values. */
    public static String csv(List<SignMap> maps) {
        var rows = new StringJoiner("\r\n", "", "\r\n");
        rows.add("predicate,method,numbers,x,y,points,wrong,more,less,unanswered,share");
        for (SignMap map : maps)
            rows.add(
                    String.join(
                            ",",
                            map.subject(),
                            map.method(),
                            map.spacing().code(),
                            "" + map.x(0),
                            "" + map.y(0),
                            "" + map.points(),
                            "" + (map.extra() + map.missing()),
                            "" + map.extra(),
                            "" + map.missing(),
                            "" + map.unanswered(),
                            "" + map.share()));
        return rows.toString();
    }
}
