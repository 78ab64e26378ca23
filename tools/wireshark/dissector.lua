-- Shows the announcements of Geminga (src/discovery/announcement/ANNOUNCEMENT.md) in Wireshark and tshark, and sealed ones
-- (src/discovery/sealing/SEALING.md) with the help of geminga-unseal. The build puts it behind `schema`, a table that it makes of
-- announcement.proto, and calls both geminga.lua. Nothing in a datagram is believed: it is text and numbers.

local geminga = Proto("geminga", "Geminga announcement")

geminga.prefs.key_file = Pref.string("Key files", "", "Key files of the team, as gemingad has them, with : between them; empty: sealed datagrams stay closed")
geminga.prefs.unseal = Pref.string("Program that opens", "geminga-unseal", "The program that opens sealed datagrams with these keys")
geminga.prefs.most = Pref.uint("Most datagrams to open", 20000, "A datagram takes the start of a program, some milliseconds; more than these stay closed")

local udp_port = 4717
local format = 0x014e4d47 -- the octets G M N and the version 1
local deepest = 100 -- groups of unknown fields in each other, as the library of protobuf has it

-- The fields that Wireshark shows and filters by: geminga.FIELD of an announcement, geminga.MESSAGE.FIELD of what is in it.

local makers = {
  uint32 = function(...) return ProtoField.uint32(...) end,
  uint64 = function(...) return ProtoField.uint64(...) end,
  sint32 = function(...) return ProtoField.int32(...) end,
  fixed32 = function(name, title, about) return ProtoField.uint32(name, title, base.HEX, nil, nil, about) end,
  fixed64 = function(name, title, about) return ProtoField.uint64(name, title, base.HEX, nil, nil, about) end,
  bool = function(name, title, about) return ProtoField.bool(name, title, base.NONE, nil, 0, about) end,
  string = function(name, title, about) return ProtoField.string(name, title, base.UNICODE, about) end,
  bytes = function(name, title, about) return ProtoField.bytes(name, title, base.SPACE, about) end,
  message = function(name, title, about) return ProtoField.none(name, title, about) end,
}
local decimal = {uint32 = true, uint64 = true, sint32 = true}

local fields = {}
for message_name, message in pairs(schema.messages) do
  local prefix = "geminga." .. (message_name == "Announcement" and "" or message_name:lower() .. ".")
  for _, field in pairs(message) do
    local name, title = prefix .. field.name, field.name:gsub("_", " ")
    if field.kind == "enum" then
      field.proto = ProtoField.uint32(name, title, base.DEC, schema.enums[field.enum], nil, field.about)
    elseif decimal[field.kind] then
      field.proto = makers[field.kind](name, title, base.DEC, nil, nil, field.about)
    else
      field.proto = makers[field.kind](name, title, field.about)
    end
    fields[#fields + 1] = field.proto
  end
end

local sealed = {
  envelope = ProtoField.none("geminga.sealed", "sealed"),
  version = ProtoField.uint8("geminga.sealed.version", "version", base.DEC),
  encrypted = ProtoField.bool("geminga.sealed.encrypted", "encrypted", 8, nil, 0x01),
  greets = ProtoField.bool("geminga.sealed.greets", "has a greeting", 8, nil, 0x02),
  compressed = ProtoField.bool("geminga.sealed.compressed", "compressed", 8, nil, 0x04),
  key = ProtoField.uint16("geminga.sealed.key", "key", base.HEX),
  session = ProtoField.uint64("geminga.sealed.session", "session of the sender", base.HEX),
  counter = ProtoField.uint32("geminga.sealed.counter", "counter", base.DEC),
  text = ProtoField.bytes("geminga.sealed.text", "text"),
  tag = ProtoField.bytes("geminga.sealed.tag", "tag"),
  state = ProtoField.string("geminga.sealed.state", "opened", base.UNICODE, "opened, closed: no key file is set, or why it could not be opened"),
}
local greeting = {
  all = ProtoField.none("geminga.greeting", "greeting"),
  everybody = ProtoField.bool("geminga.greeting.asks_everybody", "asks everybody", 8, nil, 0x80),
  challenge = ProtoField.uint64("geminga.greeting.challenge", "challenge", base.HEX),
  key = ProtoField.uint16("geminga.greeting.key", "opens with the key", base.HEX),
  asked = ProtoField.uint16("geminga.greeting.asked", "asks the session", base.HEX),
  echo = ProtoField.uint64("geminga.greeting.echo", "gives back the challenge", base.HEX),
}
local iri = ProtoField.string("geminga.iri", "IRI", base.UNICODE, "The name that a number of a term stands for")
local unknown = ProtoField.bytes("geminga.unknown", "unknown field", base.SPACE, "A field of a newer version")
for _, group in pairs({sealed, greeting}) do
  for _, field in pairs(group) do fields[#fields + 1] = field end
end
fields[#fields + 1] = iri
fields[#fields + 1] = unknown
geminga.fields = fields

local malformed = ProtoExpert.new("geminga.malformed", "This is no announcement", expert.group.MALFORMED, expert.severity.ERROR)
local closed = ProtoExpert.new("geminga.closed", "Sealed, and not opened", expert.group.UNDECODED, expert.severity.NOTE)
local forged = ProtoExpert.new("geminga.forged", "Not sealed by the team, or changed on the way", expert.group.SECURITY, expert.severity.WARN)
geminga.experts = {malformed, closed, forged}

-- Reading protobuf (protobuf.dev, "Encoding"). Positions count from 1. A function that reads returns nothing where the octets end too
-- early or mean nothing.

-- A number of at most 64 bits as two halves, and the position behind it.
local function varint(octets, at, last)
  local low, high = 0, 0
  for count = 0, 9 do
    local octet = at + count <= last and octets:byte(at + count)
    if not octet then return nil end
    local seven = octet % 128
    if count < 4 then
      low = low + seven * 2 ^ (7 * count)
    elseif count == 4 then
      low = low + seven % 16 * 2 ^ 28
      high = math.floor(seven / 16)
    else
      high = (high + seven * 2 ^ (7 * count - 32)) % 2 ^ 32
    end
    if octet < 128 then return low, high, at + count + 1 end
  end
  return nil
end

local function little_endian(octets, at, last)
  if at + 3 > last then return nil end
  local a, b, c, d = octets:byte(at, at + 3)
  return a + b * 2 ^ 8 + c * 2 ^ 16 + d * 2 ^ 24
end

-- Whether a text is UTF-8 (RFC 3629), which the library of protobuf demands.
local function is_utf8(text)
  local at = 1
  while at <= #text do
    local first, second = text:byte(at, at + 1)
    local more = first < 0x80 and 0 or first >= 0xc2 and first < 0xe0 and 1 or first >= 0xe0 and first < 0xf0 and 2 or first >= 0xf0 and first < 0xf5 and 3
    if not more or at + more > #text then return false end
    for i = at + 1, at + more do
      local octet = text:byte(i)
      if octet < 0x80 or octet > 0xbf then return false end
    end
    if first == 0xe0 and second < 0xa0 or first == 0xed and second > 0x9f or first == 0xf0 and second < 0x90 or first == 0xf4 and second > 0x8f then
      return false
    end
    at = at + 1 + more
  end
  return true
end

-- The position behind a value of this wire type that nobody looks at.
local function skip(octets, at, last, number, wire, depth)
  if wire == 0 then
    local _, _, behind = varint(octets, at, last)
    return behind
  elseif wire == 1 or wire == 5 then
    local behind = at + (wire == 1 and 8 or 4)
    return behind <= last + 1 and behind or nil
  elseif wire == 2 then
    local size, high, begin = varint(octets, at, last)
    return size and high == 0 and begin + size <= last + 1 and begin + size or nil
  elseif wire == 3 and depth < deepest then
    while true do
      local tag, high, begin = varint(octets, at, last)
      if not tag or high ~= 0 or tag < 8 then return nil end
      if tag % 8 == 4 then return math.floor(tag / 8) == number and begin or nil end
      at = skip(octets, begin, last, math.floor(tag / 8), tag % 8, depth + 1)
      if not at then return nil end
    end
  end
  return nil
end

local wires = {fixed32 = 5, fixed64 = 1, string = 2, bytes = 2, message = 2}
local parse

-- The value of a field, and the position behind it.
local function value_of(field, octets, at, last)
  if field.kind == "fixed32" then
    return little_endian(octets, at, last), at + 4
  elseif field.kind == "fixed64" then
    local low, high = little_endian(octets, at, last), little_endian(octets, at + 4, last)
    return high and UInt64(low, high), at + 8
  end
  local low, high, behind = varint(octets, at, last)
  if not low then return nil end
  if wires[field.kind] == 2 then
    if high ~= 0 or behind + low > last + 1 then return nil end
    local text = octets:sub(behind, behind + low - 1)
    if field.kind == "string" and not is_utf8(text) then return nil end
    if field.kind == "message" then
      local items, is_whole = parse(octets, behind, behind + low - 1, schema.messages[field.message])
      return {items = items, is_whole = is_whole}, behind + low
    end
    return text, behind + low
  elseif field.kind == "uint64" then
    return UInt64(low, high), behind
  elseif field.kind == "sint32" then
    return low % 2 == 0 and low / 2 or -(low + 1) / 2, behind
  elseif field.kind == "bool" then
    return low ~= 0 or high ~= 0, behind
  end
  return low, behind
end

-- The fields between two positions, each with its place, and whether all could be read.
function parse(octets, at, last, message)
  local items = {}
  while at <= last do
    local tag, high, begin = varint(octets, at, last)
    if not tag or high ~= 0 or tag < 8 then return items, false end
    local number, wire = math.floor(tag / 8), tag % 8
    local field = message[number]
    local is_packed = field and field.repeated and wire == 2 and (wires[field.kind] or 0) ~= 2
    if field and is_packed then
      local size, above, first = varint(octets, begin, last)
      if not size or above ~= 0 or first + size > last + 1 then return items, false end
      local behind = first + size
      while first < behind do
        local value, next_one = value_of(field, octets, first, behind - 1)
        if value == nil then return items, false end
        items[#items + 1] = {field = field, value = value, at = first, size = next_one - first}
        first = next_one
      end
      at = behind
    elseif field and wire == (wires[field.kind] or 0) then
      local value, behind = value_of(field, octets, begin, last)
      if value == nil then return items, false end
      items[#items + 1] = {field = field, value = value, at = at, size = behind - at}
      if field.kind == "message" and not value.is_whole then return items, false end
      at = behind
    else
      local behind = skip(octets, begin, last, number, wire, 0)
      if not behind then return items, false end
      items[#items + 1] = {number = number, at = at, size = behind - at}
      at = behind
    end
  end
  return items, true
end

-- The last value of a field, which counts where it is there several times.
local function one(items, name)
  local found
  for _, item in ipairs(items) do
    if item.field and item.field.name == name then found = item.value end
  end
  return found
end

local function all(items, name)
  local found = {}
  for _, item in ipairs(items) do
    if item.field and item.field.name == name then found[#found + 1] = item.value end
  end
  return found
end

-- Showing.

local function harmless(text) return (text:gsub("%c", "?")) end

local function address(octets)
  if #octets == 4 then return table.concat({octets:byte(1, 4)}, ".") end
  if #octets ~= 16 then return nil end
  local groups = {}
  for i = 1, 15, 2 do groups[#groups + 1] = ("%x"):format(octets:byte(i) * 256 + octets:byte(i + 1)) end
  return table.concat(groups, ":")
end

-- The IRIs of the terms, in order.
local function iris_of(items)
  local spaces, iris = all(items, "namespaces"), {}
  for i, term in ipairs(all(items, "terms")) do
    local number = one(term.items, "namespace_number") or 0
    iris[i] = (number == 0 and "" or spaces[number] or "?") .. (one(term.items, "local") or "")
  end
  return iris
end

local function show(items, tvb, tree, iris)
  for _, item in ipairs(items) do
    local range = tvb(item.at - 1, item.size)
    local field = item.field
    if not field then
      tree:add(unknown, range):append_text((" (number %d)"):format(item.number))
    elseif field.kind == "message" then
      local branch = tree:add(field.proto, range)
      local name = one(item.value.items, "name") or one(item.value.items, "key") or one(item.value.items, "local")
      if name then branch:append_text(": " .. harmless(name)) end
      show(item.value.items, tvb, branch, iris)
    else
      local leaf
      if field.kind == "bytes" then
        -- The value of octets is their range, without the tag and size before it.
        leaf = #item.value == 0 and tree:add(range, field.name .. ": empty") or tree:add(field.proto, tvb(item.at - 1 + item.size - #item.value, #item.value))
        local words = field.name:find("address") and address(item.value)
        if words then leaf:append_text(" (" .. words .. ")") end
      else
        leaf = tree:add(field.proto, range, item.value)
      end
      if field.name:find("_term$") and iris[item.value] then
        leaf:add(iri, range, iris[item.value]):set_generated()
        leaf:append_text(" (" .. harmless(iris[item.value]) .. ")")
      end
    end
  end
end

local function count_of(items, name)
  local count = 0
  for _, peer in ipairs(all(items, "peers")) do count = count + #all(peer.items, name) end
  return count
end

local function summary(items)
  local kind = schema.enums.Kind[one(items, "kind") or 0] or "KIND_UNKNOWN"
  local id = ("%08x"):format(one(items, "participant") or 0)
  local name = one(items, "name")
  local text = ("%s of %s"):format(kind:gsub("^KIND_", ""):lower(), id)
  if name and name ~= "" then text = text .. " (" .. harmless(name) .. ")" end
  text = text .. ", revision " .. tostring(one(items, "revision") or 0)
  local publications, subscriptions = count_of(items, "publications"), count_of(items, "subscriptions")
  if publications + subscriptions > 0 then text = text .. (", offers %d, asks for %d"):format(publications, subscriptions) end
  return text
end

-- Shows an announcement. False: it is none.
local function dissect_announcement(tvb, pinfo, tree)
  local octets = tvb:raw()
  local items, is_whole = parse(octets, 1, #octets, schema.messages.Announcement)
  show(items, tvb, tree, iris_of(items))
  if is_whole and one(items, "format") == format then
    pinfo.cols.info:set(summary(items))
    return true
  end
  tree:add_proto_expert_info(malformed)
  pinfo.cols.info:set("no announcement: " .. (is_whole and "another format" or "it cannot be read to its end"))
  return false
end

-- Opening what is sealed. Each datagram is opened once, since Wireshark dissects it whenever it is looked at.

local answers, asked = {}, 0

local function quoted(word) return "'" .. word:gsub("'", "'\\''") .. "'" end

function geminga.prefs_changed() answers, asked = {}, 0 end

-- The state, and the greeting and announcement in hexadecimal where it was opened.
local function unseal(octets)
  if geminga.prefs.key_file == "" then return {state = "closed"} end
  local answer = answers[octets]
  if answer then return answer end
  if asked >= geminga.prefs.most then return {state = "closed, as more than " .. geminga.prefs.most .. " are sealed"} end
  asked = asked + 1
  local command = quoted(geminga.prefs.unseal)
  for file in geminga.prefs.key_file:gmatch("[^:]+") do command = command .. " --key-file=" .. quoted(file) end
  local pipe = io.popen(command .. " " .. octets:gsub(".", function(c) return ("%02x"):format(c:byte()) end) .. " 2>&1", "r")
  local line = pipe and pipe:read("*l") or ""
  if pipe then pipe:close() end
  local greets, text = line:match("^opened %a+ %x+ (%S+) (%S+)$")
  answer = greets and {state = "opened", greeting = greets, text = text} or {state = harmless(line:match("^rejected (.+)$") or line)}
  answers[octets] = answer
  return answer
end

local function show_greeting(tvb, tree)
  local branch = tree:add(greeting.all, tvb())
  branch:add(greeting.everybody, tvb(0, 1))
  local first = tvb(0, 1):uint()
  local at = 3
  local function take(field, size, count)
    for _ = 1, count do
      if at + size > tvb:len() then return end
      branch:add(field, tvb(at, size))
      at = at + size
    end
  end
  if first % 128 >= 64 then take(greeting.challenge, 8, 1) end
  take(greeting.key, 2, first % 16)
  take(greeting.asked, 2, tvb(1, 1):uint())
  take(greeting.echo, 8, tvb(2, 1):uint())
end

local function tvb_of(hexadecimal, title) return ByteArray.new(hexadecimal):tvb(title) end

-- What is not encrypted can be read without a key: the octets of greeting and announcement, unless they are compressed.
local function readable(tvb, bits)
  if bits % 2 == 1 or bits % 8 >= 4 then return nil end
  local text = tvb(16, tvb:len() - 32):bytes():tohex(true)
  if bits % 4 < 2 then return "-", text end
  if #text < 6 then return nil end
  local first, sessions, echoes = tonumber(text:sub(1, 2), 16), tonumber(text:sub(3, 4), 16), tonumber(text:sub(5, 6), 16)
  local size = 2 * (3 + (first % 128 >= 64 and 8 or 0) + 2 * (first % 16) + 2 * sessions + 8 * echoes)
  if size > #text then return nil end
  return text:sub(1, size), text:sub(size + 1)
end

local function dissect_sealed(tvb, pinfo, tree)
  local branch = tree:add(sealed.envelope, tvb())
  if tvb:len() < 32 or tvb(1, 1):uint() < 0x10 or tvb(1, 1):uint() > 0x17 then
    branch:add_proto_expert_info(malformed)
    pinfo.cols.info:set("sealed: no envelope of version 1")
    return
  end
  branch:add(sealed.version, tvb(1, 1), math.floor(tvb(1, 1):uint() / 16))
  branch:add(sealed.encrypted, tvb(1, 1))
  branch:add(sealed.greets, tvb(1, 1))
  branch:add(sealed.compressed, tvb(1, 1))
  branch:add(sealed.key, tvb(2, 2))
  branch:add(sealed.session, tvb(4, 8))
  branch:add(sealed.counter, tvb(12, 4))
  if tvb:len() > 32 then branch:add(sealed.text, tvb(16, tvb:len() - 32)) end
  branch:add(sealed.tag, tvb(tvb:len() - 16, 16))
  local answer = unseal(tvb:raw())
  branch:add(sealed.state, tvb(), answer.state):set_generated()
  local words = ("sealed with %04x by session %s: %s"):format(tvb(2, 2):uint(), tvb(4, 8):bytes():tohex(true), answer.state)
  pinfo.cols.info:set(words)
  if answer.state == "forged" then branch:add_proto_expert_info(forged) end
  local greets, text = answer.greeting, answer.text
  if not text then
    if answer.state ~= "forged" then greets, text = readable(tvb, tvb(1, 1):uint() % 16) end
    if not text then
      branch:add_proto_expert_info(closed)
      return
    end
  end
  if greets ~= "-" then show_greeting(tvb_of(greets, "Greeting"), branch) end
  if text ~= "-" and text ~= "" then dissect_announcement(tvb_of(text, "Announcement"), pinfo, tree) end
end

function geminga.dissector(tvb, pinfo, tree)
  if tvb:len() == 0 then return 0 end
  pinfo.cols.protocol:set("Geminga")
  local branch = tree:add(geminga, tvb())
  if tvb(0, 1):uint() == 0x47 then
    dissect_sealed(tvb, pinfo, branch)
  else
    dissect_announcement(tvb, pinfo, branch)
  end
  return tvb:len()
end

DissectorTable.get("udp.port"):add(udp_port, geminga)
