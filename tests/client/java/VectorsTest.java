import geminga.Identity;
import geminga.Message;
import geminga.Offer;
import geminga.Request;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Inbox;
import geminga.protocol.Keys;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import geminga.protocol.LineException;
import geminga.protocol.Parameter;
import geminga.protocol.Places;
import geminga.protocol.Reply;
import geminga.protocol.SealedFrame;
import geminga.protocol.SealedFrame.Direction;
import geminga.protocol.Sequence;
import geminga.protocol.Statement;
import geminga.protocol.Told;
import geminga.protocol.WireFrame;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;

/** The vectors of all languages: tests/client/vectors and the worked examples of GCNP.md. */
final class VectorsTest {
    private static final HexFormat HEX = HexFormat.of();

    static void identitiesAreThoseOfTheTable() throws Exception {
        for (String[] row : Check.rows("identities.tsv")) {
            String representation = row[2].isEmpty() ? "" : "<" + row[2] + ">";
            Identity identity = switch (row[0]) {
                case "number" -> Identity.number(Long.parseLong(row[1]));
                case "text" -> Identity.text(row[1]);
                case "concept" -> Identity.concept("<" + row[1] + ">", representation);
                default -> Identity.concept(row[1], representation);
            };
            Check.equal(row[3], Long.toString(identity.id32()));
        }
    }

    static void shortNamesHaveNoNumberWithoutTheDaemon() throws Exception {
        Check.fails(IllegalStateException.class, () -> Identity.concept("soccer:BallInfo").id32());
        Check.fails(IllegalStateException.class, () -> Identity.concept("<http://example.org/a>", "soccer:Pixels").id32());
    }

    static void framesAreThoseOfTheTable() throws Exception {
        for (String[] row : Check.rows("frames.tsv")) {
            Frame frame = Frame.ofDatagram(ByteBuffer.wrap(HEX.parseHex(row[4])));
            if (row[0].equals("refused")) {
                Check.equal(null, frame);
                continue;
            }
            Check.equal(row[0], frame.kind().name().toLowerCase());
            Check.equal(row[1], Life.write(frame.life()));
            Check.equal(row[2], Long.toUnsignedString(frame.sequence()));
            Check.equal(row[3], HEX.formatHex(frame.payload()));
            Check.equal(row[4], HEX.formatHex(frame.write()));
        }
    }

    static void sealedFramesAreThoseOfTheTable() throws Exception {
        String ring = "6208:618408bc05ef2b7c262ac0676abe39df9dfe9db66ca3fe78e3e00d4cda7f5fc8:201c6285b39c9e9b12c712d9f5045fc698f675d1d8957dbca1d05d6fbceea32b";
        for (String[] row : Check.rows("sealed.tsv")) {
            ChannelKeys keys = ChannelKeys.read(row[1].equals("3") ? "authenticated" : "encrypted", ring);
            Direction direction = Direction.valueOf((row[0].equals("refused") ? row[1] : row[0]).toUpperCase());
            if (row[0].equals("refused")) {
                WireFrame frame = WireFrame.ofDatagram(ByteBuffer.wrap(HEX.parseHex(row[2])));
                if (frame != null) Check.equal(null, keys.open(frame, direction));
                continue;
            }
            Frame frame = new Frame(Frame.Kind.valueOf(row[2].toUpperCase()), Life.read(row[3]), Long.parseUnsignedLong(row[4]), HEX.parseHex(row[8]));
            SealedFrame sealed = keys.seal(frame, direction, Integer.parseInt(row[6]), Long.parseUnsignedLong(row[7]));
            Check.equal(row[9], HEX.formatHex(sealed.write()));
            Check.equal(row[5], String.format("%04x", sealed.key()));
            SealedFrame read = (SealedFrame) WireFrame.ofDatagram(ByteBuffer.wrap(HEX.parseHex(row[9])));
            Check.equal(row[6] + " " + row[7], read.port() + " " + Long.toUnsignedString(read.counter()));
            Frame opened = keys.open(read, direction);
            Check.equal(HEX.formatHex(opened.payload()), HEX.formatHex(keys.open(read, direction).payload())); // though a cipher opens no frame twice
            Check.equal(HEX.formatHex(frame.write()), HEX.formatHex(opened.write()));
            WireFrame streamed = new FrameReader(Limits.TCP_MESSAGE).next(ByteBuffer.wrap(HEX.parseHex(row[9])));
            Check.equal(HEX.formatHex(frame.write()), HEX.formatHex(keys.open(streamed, direction).write()));
        }
    }

    static void messagesAreNewAsTheTableSays() throws Exception {
        long begin = Long.MAX_VALUE - 1_000_000_000L; // the clock may begin anywhere
        for (String[] row : Check.rows("sequence.tsv")) {
            Sequence sequence = new Sequence();
            List<String> missed = new ArrayList<>();
            for (String word : row[0].split(" ")) {
                if (word.equals("again")) {
                    sequence.interrupt(7);
                    continue;
                }
                String[] numbers = word.split(":");
                long before = sequence.take(7, Long.parseUnsignedLong(numbers[1]), false, begin + 1_000_000L * Long.parseLong(numbers[0]));
                missed.add(before < 0 ? "-" : Long.toString(before));
            }
            Check.equal(row[1], String.join(" ", missed));
        }
    }

    static void placesAreSharedAsTheTableSays() throws Exception {
        for (String[] row : Check.rows("places.tsv")) {
            Places<Integer> places = new Places<>(Integer.parseInt(row[0]));
            List<String> found = new ArrayList<>();
            int newcomer = 0;
            for (String word : row[1].split(" ")) {
                if (word.startsWith("!")) {
                    places.serve(Integer.parseInt(word.substring(1)));
                } else if (word.startsWith("-")) {
                    places.leave(Integer.parseInt(word.substring(1)));
                } else {
                    Places.Outcome<Integer> outcome = places.take(++newcomer, word);
                    found.add(!outcome.isTaken() ? "refused" : outcome.loser() == null ? "taken" : "taken-" + outcome.loser());
                }
            }
            Check.equal(row[2], String.join(" ", found));
        }
    }

    static void aFullInboxLosesWhatTheTableSays() throws Exception {
        for (String[] row : Check.rows("inbox.tsv")) {
            Inbox inbox = new Inbox(Integer.parseInt(row[0]));
            List<String> taken = new ArrayList<>();
            int lost = 0;
            for (String word : row[1].split(" ")) {
                if (word.equals("-")) {
                    taken.add(words(inbox.take()));
                } else if (word.startsWith("s")) {
                    inbox.putStreamed(message(word));
                } else {
                    lost += inbox.putDatagram(message(word));
                }
            }
            while (!inbox.isEmpty()) taken.add(words(inbox.take()));
            Check.equal(row[2], String.join(" ", taken));
            Check.equal(row[3], Integer.toString(lost));
        }
    }

    private static Message message(String word) {
        String[] numbers = word.substring(1).split(":");
        return new Message(new byte[0], Long.parseLong(numbers[0]), Long.parseLong(numbers[1]), Long.parseLong(numbers[2]), null);
    }

    private static String words(Message message) {
        return message.life() + ":" + message.sequence() + ":" + message.missed();
    }

    static void linesOfTheDaemonAreReadAndWrittenAgain() throws Exception {
        for (String line : Check.block("events")) {
            Reply reply = Reply.read(line);
            Check.equal(line, reply != null ? reply.write() : Told.read(Statement.read(line)).write().write());
        }
    }

    static void keysAreTakenForKeysAndAttributesForAttributes() throws Exception {
        Told told = Told.read(Statement.read(Check.block("events").get(1)));
        Check.equal(Map.of("attr.x", "1", "modes", "3", "rate", "30", "where", "left"), told.attributes());
        Check.equal(5001, told.match().port());
        Told costly = Told.read(Statement.read(Check.block("events").stream().filter(line -> line.contains(" attr.cost=")).findFirst().orElseThrow()));
        Check.equal("3", costly.attributes().get("cost"));
        Check.equal(1L, costly.match().cost());
        Check.equal("", costly.match().via());
        Told served = Told.read(Statement.read("1 pub add service=a/1/1 provider=a/1 text=x degree=converted mode=oto port=1 protocol=udp convert=a:A>a:B cost=2 attr.via=x via=udp://10.0.0.7:6000/b/1/1"));
        Check.equal("udp://10.0.0.7:6000/b/1/1", served.match().via());
        Check.equal("x", served.attributes().get("via"));
        Told far = Told.read(Statement.read("1 pub add service=a/1/1 provider=a/1 text=x degree=exact mode=oto port=1 protocol=udp attr.path=/left hops=2 path=base/tower reachable=no"));
        Check.equal("2 base/tower false", far.match().hops() + " " + far.match().path() + " " + far.match().reachable());
        Check.equal("/left", far.attributes().get("path"));
        Told near = Told.read(Statement.read("1 pub add service=a/1/1 provider=a/1 text=x degree=exact mode=oto port=1 protocol=udp path=/left attr.reachable=no"));
        Check.equal("0  true", near.match().hops() + " " + near.match().path() + " " + near.match().reachable());
        Check.equal("/left no", near.attributes().get("path") + " " + near.attributes().get("reachable"));
        Check.equal("attr.via", served.write().parameters().get(served.write().parameters().size() - 1).key());
        Check.equal(List.of("soccer:PolarRobotFrame", "soccer:CartesianRobotFrame"), costly.match().conversion());
    }

    static void aChainOfConversionsIsReadNameByName() throws Exception {
        String line = "7 pub add service=a/1/1 text=x degree=converted mode=oto convert=";
        for (String chain : List.of("a:A>a:B", "a:A>a:B>a:C", "<http://e.org/a>><http://e.org/b>", "a:A><http://e.org/b>>a:C", "<http://e.org/a>>a:B")) {
            List<String> names = Told.read(Statement.read(line + chain)).match().conversion();
            Check.equal(chain, String.join(">", names));
            for (String name : names) Check.that(name.matches("a:[ABC]|<http://e.org/[ab]>"), name);
        }
        for (String none : List.of("a:A", ">a:A", "a:A>>a:B", "a:A>", "<a", "<a>", "<a>b>c", ">", "<>>")) {
            Check.fails(LineException.class, () -> Told.read(Statement.read(line + none)));
        }
    }

    static void offersAndRequestsAreStatedAsTheSpecificationSays() throws Exception {
        List<String> lines = Check.block("requests");
        int count = 0;
        for (int i = 0; i < lines.size(); ++i) {
            if (!lines.get(i).matches("[0-9]+ (pub|sub) create .*")) continue;
            // A participant has no channel, and no request of the library asks for one.
            if (lines.get(i).contains("mode=participant")) continue;
            String next = i + 1 < lines.size() && lines.get(i + 1).startsWith("= ") ? lines.get(i + 1).substring(2) : lines.get(i);
            Check.equal(next, stated(lines.get(i)));
            ++count;
        }
        Check.that(count > 10, count + " lines");
    }

    static void whatTheDaemonWouldRefuseIsRefusedAtOnce() throws Exception {
        List<String> lines = Check.block("refused");
        for (int i = 0; i < lines.size(); i += 2) {
            String line = lines.get(i);
            // The library opens the port itself and numbers its requests itself.
            boolean isOurs = line.matches("[1-9][0-9]* (pub|sub) create .*") && !line.matches(".*create mode=oto id=7 port=0");
            boolean isOfAnAddress = line.contains("address=0.0.0.0");
            if (isOurs && !isOfAnAddress) Check.fails(IllegalArgumentException.class, () -> stated(line));
        }
    }

    static void changesStateWhatDiffersAndTakeBackWhatIsGone() {
        Request before = Request.read("mode=oto text=kick match=exact where=\"rate > 3\" limit=4 rate=1");
        Request after = Request.read("mode=oto concept=soccer:BallInfo limit=4 rate=2 attr.port=9");
        Check.equal("{concept=soccer:BallInfo, match=narrower, where=, attr.port=9, rate=2}", after.changesFrom(before).toString());
        Check.equal(Map.of(), after.changesFrom(after));
        Offer offer = Offer.read("mode=oto concept=soccer:BallInfo representation=soccer:Pixels scope=host priority=3");
        Check.equal("{representation=, priority=0, scope=}", Offer.read("mode=oto concept=soccer:BallInfo").changesFrom(offer).toString());
    }

    static void attributesAreToldFromSlips() throws Exception {
        for (String slip : List.of("wehre", "Where", "wheres", "whre", "atr.x", "pot")) Check.fails(LineException.class, () -> Keys.stated(slip));
        for (String name : List.of("rate", "camera", "ports2", "channel", "modes1", "x")) Check.equal(name, Keys.stated(name));
        for (String name : List.of("on", "in")) Check.equal("attr." + name, Keys.stating(name));
        for (String key : Keys.reserved()) {
            Check.fails(LineException.class, () -> Keys.stated(key));
            Check.equal(key, Keys.stated(Keys.stating(key)));
            Check.equal(key, Keys.shown(Keys.showing(key)));
        }
    }

    private static String stated(String line) throws LineException {
        String[] words = line.split(" ", 4);
        Map<String, String> parameters = words[1].equals("pub") ? Offer.read(words[3]).parameters() : Request.read(words[3]).parameters();
        List<Parameter> written = new ArrayList<>();
        parameters.forEach((key, value) -> written.add(new Parameter(key, value)));
        if (words[1].equals("pub") && !parameters.containsKey("port")) throw new IllegalArgumentException("port");
        return new Statement(Long.parseLong(words[0]), words[1], "create", written).write();
    }
}
